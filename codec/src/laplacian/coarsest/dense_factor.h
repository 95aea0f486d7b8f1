// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The matrix of a small coarsest level, factored [DELT-7].
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "laplacian/multigrid/level/level.h"
#include "laplacian/multigrid/level/row.h"

namespace deltamesh::multigrid {

/// L D L^T of N = K M^-1 K + E E^T, dense, in doubles.
class DenseFactor {
 public:
  /// O(n^3).
  DenseFactor(const Level& level, std::span<const double> inverse_mass);

  /// Overwrites `b` (n) with the solution. A pivot that is not above 0, by rounding, gives 0. O(n^2).
  void solve(std::span<Double4> b) const noexcept;

 private:
  double* row(std::size_t i) noexcept { return &lower_[i * size_]; }
  const double* row(std::size_t i) const noexcept { return &lower_[i * size_]; }
  void assemble(const Level& level, std::span<const double> inverse_mass);
  void factor();

  std::size_t size_;
  std::vector<double> lower_;             ///< size_ rows of as many; L below the diagonal
  std::vector<double> inverse_diagonal_;  ///< 1 / D, or 0
};

}  // namespace deltamesh::multigrid
