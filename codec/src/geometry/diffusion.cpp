// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "geometry/diffusion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace deltamesh {
namespace {

/// Hands `charge` to the neighbours of `vertex` that come later; what no one can take is lost.
void diffuse(const Adjacency& graph, std::uint32_t vertex, const Vec3& charge, std::vector<Vec3>& carried) {
  const auto neighbors = graph.of(vertex);
  double degrees = 0;
  std::size_t first = neighbors.size();
  for (; first > 0 && neighbors[first - 1] > vertex; --first) degrees += graph.degree(neighbors[first - 1]);
  if (!(degrees > 0)) return;
  // A share in proportion to the degree, divided by the degree: the same for every neighbour.
  const Vec3 share = (1.0 / degrees) * charge;
  for (const std::uint32_t later : neighbors.subspan(first)) carried[later] = carried[later] + share;
}

/// Quantises vertex after vertex; `take` gets each vertex and its three symbols. False where a symbol is too
/// large.
template <class Take>
bool walk(const Adjacency& graph, std::span<const Vec3> deltas, const DeltaQuantizer& quantizer,
          double strength, Take take) {
  const bool diffuses = strength > 0;
  std::vector<Vec3> carried(diffuses ? deltas.size() : 0);
  for (std::uint32_t i = 0; i < deltas.size(); ++i) {
    const Vec3 target = diffuses ? deltas[i] + carried[i] : deltas[i];
    std::array<std::int32_t, 3> symbols{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double symbol = quantizer.symbol(target[axis]);
      if (!(std::abs(symbol) <= kLargestSymbol)) return false;
      symbols[axis] = static_cast<std::int32_t>(symbol);
    }
    take(i, symbols);
    if (!diffuses) continue;
    Vec3 left{};
    for (std::size_t axis = 0; axis < 3; ++axis) left[axis] = target[axis] - quantizer.value(symbols[axis]);
    diffuse(graph, i, (strength * graph.degree(i)) * left, carried);
  }
  return true;
}

}  // namespace

Result<std::vector<std::int32_t>> quantize_deltas(const Adjacency& graph, std::span<const Vec3> deltas,
                                                  const DeltaQuantizer& quantizer, double strength) {
  const std::size_t count = deltas.size();
  std::vector<std::int32_t> symbols(3 * count);
  const auto store = [&](std::uint32_t i, const std::array<std::int32_t, 3>& q) {
    for (std::size_t axis = 0; axis < 3; ++axis) symbols[axis * count + i] = q[axis];
  };
  if (!walk(graph, deltas, quantizer, strength, store))
    return Error{.code = ErrorCode::kInvalidArgument,
                 .message = "the step is too small for this mesh: deltas exceed 2^30 steps"};
  return symbols;
}

double quantization_error(const Adjacency& graph, std::span<const Vec3> deltas,
                          const DeltaQuantizer& quantizer, double strength) {
  double sum = 0;
  const auto add = [&](std::uint32_t i, const std::array<std::int32_t, 3>& q) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double error = deltas[i][axis] - quantizer.value(q[axis]);
      sum += error * error;
    }
  };
  if (!walk(graph, deltas, quantizer, strength, add)) return std::numeric_limits<double>::infinity();
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(deltas.size(), 1)));
}

}  // namespace deltamesh
