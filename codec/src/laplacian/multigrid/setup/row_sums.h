// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A row of a sparse matrix in the making.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/large_vector.h"

namespace deltamesh::multigrid {

/// Sums over columns met in any order. A column is there once it has been met, whatever the sum.
class RowSums {
 public:
  explicit RowSums(std::uint32_t columns) : sums_(columns), row_of_(columns, 0), touched_(columns + 1) {}

  void begin() noexcept {
    count_ = 0;
    ++row_;
  }

  /// Without a branch, which could not be predicted.
  void add(std::uint32_t column, float value) noexcept {
    const bool is_new = row_of_[column] != row_;
    row_of_[column] = row_;
    touched_[count_] = column;
    count_ += is_new ? 1 : 0;
    sums_[column] = (is_new ? 0.0F : sums_[column]) + value;
  }

  std::span<const std::uint32_t> columns() const noexcept { return {touched_.data(), count_}; }
  float of(std::uint32_t column) const noexcept { return sums_[column]; }

 private:
  LargeVector<float> sums_;
  LargeVector<std::uint32_t> row_of_;  ///< the last that met the column
  LargeVector<std::uint32_t> touched_;
  std::size_t count_ = 0;
  std::uint32_t row_ = 0;
};

}  // namespace deltamesh::multigrid
