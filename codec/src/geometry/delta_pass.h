// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The pass over the vertices in which error diffusion works, whatever decides on the symbols.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "geometry/delta_quantizer.h"
#include "topology/adjacency.h"

namespace deltamesh {

/// Hands `charge` to the neighbours of `vertex` that come later; what none of them can take is lost.
inline void diffuse_charge(const Adjacency& graph, std::uint32_t vertex, const Vec3& charge,
                           std::vector<Vec3>& carried) {
  const auto neighbors = graph.of(vertex);
  double degrees = 0;
  std::size_t first = neighbors.size();
  for (; first > 0 && neighbors[first - 1] > vertex; --first) degrees += graph.degree(neighbors[first - 1]);
  if (!(degrees > 0)) return;
  // A share in proportion to the degree, divided by the degree: the same for every neighbour.
  const Vec3 share = (1.0 / degrees) * charge;
  for (const std::uint32_t later : neighbors.subspan(first)) carried[later] = carried[later] + share;
}

/// Vertex after vertex, `choose(vertex, nearest, target)` takes three symbols for what the vertex has to
/// code, of which `nearest` are the nearest; diffusion as in quantize_deltas(). False where a nearest symbol
/// exceeds kLargestSymbol.
template <class Choose>
bool pass_over_deltas(const Adjacency& graph, std::span<const Vec3> deltas, const DeltaQuantizer& quantizer,
                      double strength, Choose choose) {
  const bool diffuses = strength > 0;
  std::vector<Vec3> carried(diffuses ? deltas.size() : 0);
  for (std::uint32_t i = 0; i < deltas.size(); ++i) {
    const Vec3 target = diffuses ? deltas[i] + carried[i] : deltas[i];
    std::array<std::int32_t, 3> nearest{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double symbol = quantizer.symbol(target[axis]);
      if (!(std::abs(symbol) <= kLargestSymbol)) return false;
      nearest[axis] = static_cast<std::int32_t>(symbol);
    }
    const std::array<std::int32_t, 3> symbols = choose(i, nearest, target);
    if (!diffuses) continue;
    Vec3 left{};
    for (std::size_t axis = 0; axis < 3; ++axis) left[axis] = target[axis] - quantizer.value(symbols[axis]);
    diffuse_charge(graph, i, (strength * graph.degree(i)) * left, carried);
  }
  return true;
}

}  // namespace deltamesh
