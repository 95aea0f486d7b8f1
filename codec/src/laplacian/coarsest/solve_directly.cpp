// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/coarsest/solve_directly.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace deltamesh::multigrid {
namespace {

Double4 widened(const Vec3& v) noexcept { return {TwoDoubles{v[0], v[1]}, TwoDoubles{v[2], 0}}; }

}  // namespace

void solve_directly(const Level& finest, const DeltaView& deltas, std::span<const Vec3> targets,
                    EnvelopeFactor& factor, std::span<Vec3> x) {
  std::vector<Double4> shares;  // of delta, for each neighbour
  std::vector<Double4> sums;
  for (std::uint32_t i = 0; i < finest.node_count(); ++i)
    shares.push_back(1.0 / unit_degree(finest, i) * widened(deltas[i]));
  for (std::uint32_t i = 0; i < finest.node_count(); ++i) {
    Double4 sum = widened(deltas[i]);
    for (std::uint32_t e = finest.offsets[i]; e < finest.offsets[i + 1]; ++e)
      sum -= shares[finest.neighbors[e]];
    sums.push_back(sum);
  }
  for (std::size_t a = 0; a < targets.size(); ++a) sums[finest.anchors[a]] += widened(targets[a]);
  factor.factor(finest);
  factor.solve(sums);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = {sums[i].xy[0], sums[i].xy[1], sums[i].zw[0]};
}

}  // namespace deltamesh::multigrid
