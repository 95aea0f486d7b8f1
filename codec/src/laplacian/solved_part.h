// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The part of a graph that is solved for: its components of at least kSmallestSolvedComponent vertices.
#pragma once

#include <cstdint>
#include <vector>

#include "topology/adjacency.h"

namespace deltamesh {

/// The solved components with vertices renumbered in the same order.
struct SolvedPart {
  std::vector<std::uint32_t> vertices;  ///< vertex of the whole graph for every row, ascending
  std::vector<std::uint32_t> rows;  ///< the reverse, per vertex of the whole graph; kNoRow where not solved
  Adjacency graph;                  ///< over rows

  static constexpr std::uint32_t kNoRow = ~std::uint32_t{0};
};

/// O(n + edges).
SolvedPart extract_solved_part(const Adjacency& graph, const Components& components);

}  // namespace deltamesh
