// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Sparse LDL^T, solved for all axes at once.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/memory/large_vector.h"
#include "laplacian/multigrid/level/row.h"

namespace deltamesh::settling {

using multigrid::Double4;

/// A symmetric matrix: its diagonal, and per row the entries beside it in ascending order of column.
struct SymmetricMatrix {
  std::vector<std::uint32_t> offsets;  ///< n + 1
  LargeVector<std::uint32_t> columns;
  LargeVector<double> values;
  std::vector<double> diagonal;  ///< n

  std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(diagonal.size()); }
};

class SparseFactor {
 public:
  /// `place`: new place of each row; `work_left`: number of multiplications allowed, from which those used
  /// are subtracted. Empty if it would take more than that, more than 2^32 or more than 200 MB, or if a pivot
  /// is 0. Time and memory grow faster than n.
  static std::optional<SparseFactor> make(const SymmetricMatrix& matrix, std::vector<std::uint32_t> place,
                                          std::uint64_t& work_left);

  /// Overwrites `b` (n) with the solution.
  void solve(std::span<Double4> b);

 private:
  /// Computes the columns, whose places and offsets are known. False if a pivot is 0.
  bool factor(const SymmetricMatrix& matrix, std::span<const std::uint32_t> parent);

  std::vector<std::uint32_t> place_;    ///< n: where row i went
  std::vector<std::uint32_t> offsets_;  ///< n + 1: columns of L below its diagonal of ones
  LargeVector<std::uint32_t> rows_;
  LargeVector<double> values_;
  std::vector<double> inverse_diagonal_;  ///< n: 1 / D
  LargeVector<Double4> work_;             ///< n
};

}  // namespace deltamesh::settling
