// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Every edge of a mesh once, in the order of its faces, without a graph.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace deltamesh {

struct MeshEdges {
  std::span<const std::uint32_t> triangles;  ///< m x 3
  /// m: bit k is set where the edge from the face's corner k to its next is to be visited.
  std::vector<std::uint8_t> visited;
  std::vector<std::uint32_t> lone_vertices{};  ///< those without edges, ascending

  /// visit(a, b), a and b being different. O(m).
  template <class Visit>
  void for_each(Visit visit) const {
    for (std::size_t f = 0; f < visited.size(); ++f) {
      const std::uint32_t* const corner = triangles.data() + 3 * f;
      if ((visited[f] & 1) != 0) visit(corner[0], corner[1]);
      if ((visited[f] & 2) != 0) visit(corner[1], corner[2]);
      if ((visited[f] & 4) != 0) visit(corner[2], corner[0]);
    }
  }
};

/// The edges of any triangle soup. O(n + m log), by way of a graph.
MeshEdges find_edges(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count);

}  // namespace deltamesh
