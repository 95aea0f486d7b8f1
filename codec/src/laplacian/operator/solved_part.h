// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The part of a graph that is solved for: its components of at least kSmallestSolvedComponent vertices.
#pragma once

#include <cstddef>
#include <cstdint>

#include "topology/adjacency.h"
#include "topology/vertex_subset.h"

namespace deltamesh {

/// The solved components with vertices renumbered in the same order.
struct SolvedPart {
  Adjacency graph{};            ///< over rows
  Components components{};      ///< of `graph`
  std::size_t row_count = 0;    ///< solved vertices
  std::size_t whole_count = 0;  ///< vertices of the whole graph
  VertexSubset vertices{};      ///< of the whole graph, the rows'

  bool is_whole() const noexcept { return row_count == whole_count; }
  /// The vertex of the whole graph at this row.
  std::uint32_t vertex(std::size_t row) const noexcept {
    return vertices.vertex(static_cast<std::uint32_t>(row));
  }
};

/// Takes the graph apart in place. O(n + edges), or O(n) where all are solved.
SolvedPart extract_solved_part(Adjacency graph, Components components);

}  // namespace deltamesh
