// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/operator/delta.h"

#include <algorithm>

namespace deltamesh {

std::vector<Vec3> delta_coordinates(const Adjacency& graph, std::span<const Vec3> positions) {
  std::vector<Vec3> deltas(positions.size());
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    if (graph.degree(v) == 0) continue;
    Vec3 sum{};
    for (const std::uint32_t neighbor : graph.of(v)) sum = sum + positions[neighbor];
    deltas[v] = positions[v] - (1.0 / graph.degree(v)) * sum;
  }
  return deltas;
}

std::vector<Vec3> delta_coordinates(const SolvedPart& part, std::span<const Vec3> positions) {
  if (part.is_whole()) return delta_coordinates(part.graph, positions);
  std::vector<Vec3> solved(part.row_count);
  for (std::size_t i = 0; i < solved.size(); ++i) solved[i] = positions[part.vertex(i)];
  return delta_coordinates(part.graph, solved);
}

double delta_range(std::span<const Vec3> deltas) noexcept {
  if (deltas.empty()) return 0;
  double lowest = deltas.front()[0];
  double highest = lowest;
  for (const Vec3& delta : deltas) {
    lowest = std::min({lowest, delta[0], delta[1], delta[2]});
    highest = std::max({highest, delta[0], delta[1], delta[2]});
  }
  return highest - lowest;
}

}  // namespace deltamesh
