// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The matrix of a level of few nodes, factored [DELT-7].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "laplacian/multigrid/level/level.h"
#include "laplacian/multigrid/level/row.h"

namespace deltamesh::multigrid {

/// An order of nodes in which neighbours are near each other, for factors of narrow rows: the reverse of a
/// breadth-first order that begins at an end of the graph [Cuthill and McKee 1969, reversed as by George
/// 1971]. `nodes`: overwritten. O(n + edges).
void order_narrowly(const Level& level, std::vector<std::uint32_t>& nodes);

/// L D L^T of N = K M^-1 K + E E^T in doubles, nodes in order_narrowly()'s order, each row from its first
/// entry that is not 0 on. One object may serve one level after the other; it keeps its memory.
class EnvelopeFactor {
 public:
  /// O(n w^2) for n nodes and rows of w entries.
  void factor(const Level& level);

  /// Overwrites `b` (n) with the solution. A pivot that is not above 0, by rounding, gives 0. O(n w).
  void solve(std::span<Double4> b);

 private:
  struct Entry {
    std::uint32_t column;
    double value;
  };
  void copy_k(const Level& level);
  std::span<const Entry> row_of_k(std::size_t i) const noexcept;
  void make_rows();
  void assemble(std::span<const std::uint32_t> anchors);
  void factor();
  double* row(std::size_t i) noexcept { return &lower_[begin_[i]]; }
  const double* row(std::size_t i) const noexcept { return &lower_[begin_[i]]; }

  std::size_t size_ = 0;
  std::vector<std::uint32_t> nodes_;        ///< n: of each row
  std::vector<std::uint32_t> numbers_;      ///< n: the row of each node
  std::vector<std::uint32_t> first_entry_;  ///< n + 1: in `entries_`
  std::vector<Entry> entries_;              ///< of K, row by row
  std::vector<double> inverse_mass_;        ///< n
  std::vector<std::size_t> first_column_;   ///< n: of each row of N the lowest
  std::vector<std::size_t> begin_;          ///< n: where the row is in `lower_`
  std::vector<double> lower_;               ///< of N, then of L, up to the diagonal
  std::vector<double> inverse_diagonal_;    ///< n: 1 / D, or 0
  std::vector<double> scaled_;              ///< a row of L D
  std::vector<Double4> solution_;           ///< row by row
};

}  // namespace deltamesh::multigrid
