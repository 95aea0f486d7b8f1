// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The part of a graph that is solved for: its components of at least kSmallestSolvedComponent vertices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "topology/adjacency.h"

namespace deltamesh {

/// The solved components with vertices renumbered in the same order.
struct SolvedPart {
  Adjacency graph{};                      ///< over rows
  Components components{};                ///< of `graph`
  std::size_t row_count = 0;              ///< solved vertices
  std::size_t whole_count = 0;            ///< vertices of the whole graph
  std::vector<std::uint32_t> vertices{};  ///< of the whole graph, for every row, ascending; empty where all
                                          ///< are solved

  bool is_whole() const noexcept { return row_count == whole_count; }
  std::uint32_t vertex(std::size_t row) const noexcept {
    return is_whole() ? static_cast<std::uint32_t>(row) : vertices[row];
  }
  /// Nothing where the vertex is not solved for. O(log n).
  std::optional<std::uint32_t> row_of(std::uint32_t vertex) const noexcept;
};

/// Rows of vertices that are asked for in ascending order.
class RowWalk {
 public:
  explicit RowWalk(const SolvedPart& part) noexcept : part_(part) {}

  /// As SolvedPart::row_of. O(1), but for O(n) over all calls.
  std::optional<std::uint32_t> row_of(std::uint32_t vertex) noexcept {
    if (part_.is_whole()) return vertex;
    while (row_ < part_.vertices.size() && part_.vertices[row_] < vertex) ++row_;
    if (row_ == part_.vertices.size() || part_.vertices[row_] != vertex) return std::nullopt;
    return row_;
  }

 private:
  const SolvedPart& part_;
  std::uint32_t row_ = 0;
};

/// Takes the graph apart in place: no copy of it is made. O(n + edges).
SolvedPart extract_solved_part(Adjacency graph, Components components);

}  // namespace deltamesh
