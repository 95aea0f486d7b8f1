// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A row of a sparse matrix in the making.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/memory/large_vector.h"

namespace deltamesh::multigrid {

/// Sums over columns met in any order. A column is there once it has been met, whatever the sum.
class RowSums {
 public:
  explicit RowSums(std::uint32_t columns) : sums_(columns, Sum{}), touched_(columns + 1) {}

  void begin() noexcept {
    count_ = 0;
    ++row_;
  }

  /// Without a branch, which could not be predicted.
  void add(std::uint32_t column, float value) noexcept {
    Sum& sum = sums_[column];
    const std::uint32_t is_new = sum.row != row_ ? 1 : 0;
    const std::uint32_t before = std::bit_cast<std::uint32_t>(sum.value) & (is_new - 1);
    sum = {.row = row_, .value = std::bit_cast<float>(before) + value};
    touched_[count_] = column;
    count_ += is_new;
  }

  std::span<const std::uint32_t> columns() const noexcept { return {touched_.data(), count_}; }
  float of(std::uint32_t column) const noexcept { return sums_[column].value; }

 private:
  struct Sum {
    std::uint32_t row = 0;  ///< the last that met the column
    float value = 0;
  };

  LargeVector<Sum> sums_;  ///< by column
  LargeVector<std::uint32_t> touched_;
  std::size_t count_ = 0;
  std::uint32_t row_ = 0;
};

}  // namespace deltamesh::multigrid
