// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The graph of a triangle soup: which vertices share an edge.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/memory/large_vector.h"

namespace deltamesh {

class ThreadTeam;

/// Compressed rows: the neighbours of v are neighbors[offsets[v] .. offsets[v + 1]), ascending, each once,
/// never v itself.
struct Adjacency {
  LargeVector<std::uint32_t> offsets;    ///< n + 1
  LargeVector<std::uint32_t> neighbors;  ///< two entries per edge

  std::size_t vertex_count() const noexcept { return offsets.size() - 1; }
  std::uint32_t degree(std::uint32_t v) const noexcept { return offsets[v + 1] - offsets[v]; }
  std::span<const std::uint32_t> of(std::uint32_t v) const noexcept {
    return {neighbors.data() + offsets[v], neighbors.data() + offsets[v + 1]};
  }
};

/// `triangles`: m x 3 indices below `vertex_count`, m at most 2^29; degenerate and duplicate faces are
/// welcome. O(n + m).
Adjacency build_adjacency(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count);

/// From one vertex to another.
using DirectedEdge = std::array<std::uint32_t, 2>;

/// The same, faster, where the open edges are known: with these reversed and added, every edge of a face
/// comes as often in the one direction as in the other. On the threads of `team`; null: on this one. O(n + m
/// log d), d being the largest number of neighbours of a vertex.
Adjacency build_adjacency(std::span<const std::uint32_t> triangles, std::span<const DirectedEdge> open_edges,
                          std::uint32_t vertex_count, ThreadTeam* team = nullptr);

/// Connected components of the graph, numbered by their smallest vertex; an isolated vertex is one.
struct Components {
  std::uint32_t count = 0;
  LargeVector<std::uint32_t> label;  ///< n
  std::vector<std::uint32_t> size;   ///< count
};
Components find_components(const Adjacency& graph);

}  // namespace deltamesh
