// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "geometry/diffusion.h"

#include "base/try.h"

namespace deltamesh {
namespace {

Result<std::int32_t> symbol_of(const DeltaQuantizer& quantizer, double delta) {
  const double symbol = quantizer.symbol(delta);
  if (!(std::abs(symbol) <= kLargestSymbol))
    return Error{.code = ErrorCode::kInvalidArgument,
                 .message = "the step is too small for this mesh: deltas exceed 2^30 steps"};
  return static_cast<std::int32_t>(symbol);
}

/// Hands `charge` to the neighbours of `vertex` that come later; what no one can take is lost.
void diffuse(const Adjacency& graph, std::uint32_t vertex, const Vec3& charge, std::vector<Vec3>& carried) {
  double degrees = 0;
  for (const std::uint32_t neighbor : graph.of(vertex))
    if (neighbor > vertex) degrees += graph.degree(neighbor);
  if (!(degrees > 0)) return;
  // A share in proportion to the degree, divided by the degree: the same for every neighbour.
  const Vec3 share = (1.0 / degrees) * charge;
  for (const std::uint32_t neighbor : graph.of(vertex))
    if (neighbor > vertex) carried[neighbor] = carried[neighbor] + share;
}

}  // namespace

Result<std::vector<std::int32_t>> quantize_deltas(const Adjacency& graph, std::span<const Vec3> deltas,
                                                  const DeltaQuantizer& quantizer, double strength) {
  const std::size_t count = deltas.size();
  std::vector<std::int32_t> symbols(3 * count);
  std::vector<Vec3> carried(strength > 0 ? count : 0);
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec3 target = strength > 0 ? deltas[i] + carried[i] : deltas[i];
    Vec3 left{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      DELTAMESH_TRY(const std::int32_t symbol, symbol_of(quantizer, target[axis]));
      symbols[axis * count + i] = symbol;
      left[axis] = target[axis] - quantizer.value(symbol);
    }
    if (strength > 0) diffuse(graph, i, (strength * graph.degree(i)) * left, carried);
  }
  return symbols;
}

}  // namespace deltamesh
