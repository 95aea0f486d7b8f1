// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The normal equations of one small component, (L^T L + E E^T) x = L^T delta + E c, dense, in a buffer of
// fixed size.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/vec3.h"

namespace deltamesh::settling {

/// Used for one component after the other: begin(), add what there is, solve().
class DenseComponent {
 public:
  static constexpr std::uint32_t kLargest = 64;

  /// `size`: vertices, at most kLargest.
  void begin(std::uint32_t size) noexcept;

  /// The row of L of vertex `own`: `columns`, ascending, are the vertex itself and its neighbours.
  void add_row(std::uint32_t own, std::span<const std::uint32_t> columns, const Vec3& delta) noexcept;

  void add_anchor(std::uint32_t own, const Vec3& position) noexcept;

  /// U^T D U in place, for three right-hand sides. False where the matrix is not positive definite.
  bool solve() noexcept;

  const Vec3& solution(std::uint32_t own) const noexcept { return right_[own]; }

 private:
  double* row(std::uint32_t i) noexcept { return &upper_[std::size_t{i} * kLargest]; }

  std::uint32_t size_ = 0;
  std::array<double, std::size_t{kLargest} * kLargest> upper_;  ///< row i from column i to end_[i]
  std::array<std::uint32_t, kLargest> end_;                     ///< beyond it row i is zero
  std::array<Vec3, kLargest> right_;
};

}  // namespace deltamesh::settling
