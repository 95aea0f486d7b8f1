// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "topology/mesh_edges.h"

#include <algorithm>

#include "topology/adjacency.h"

namespace deltamesh {

MeshEdges find_edges(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count) {
  const Adjacency graph = build_adjacency(triangles, vertex_count);
  MeshEdges edges{.triangles = triangles, .visited = std::vector<std::uint8_t>(triangles.size() / 3)};
  std::vector<std::uint8_t> seen(graph.neighbors.size());  // in the row of the smaller end
  for (std::size_t c = 0; c < triangles.size(); ++c) {
    const auto [a, b] = std::minmax(triangles[c], triangles[c % 3 == 2 ? c - 2 : c + 1]);
    if (a == b) continue;
    const auto row = graph.of(a);
    const auto place = std::lower_bound(row.begin(), row.end(), b) - row.begin();
    std::uint8_t& mark = seen[graph.offsets[a] + static_cast<std::size_t>(place)];
    if (mark == 0) edges.visited[c / 3] |= static_cast<std::uint8_t>(1U << (c % 3));
    mark = 1;
  }
  for (std::uint32_t v = 0; v < vertex_count; ++v)
    if (graph.degree(v) == 0) edges.lone_vertices.push_back(v);
  return edges;
}

}  // namespace deltamesh
