// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// One row of a sparse matrix at a time, from sums over columns met in any order.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "base/large_vector.h"

namespace deltamesh::settling {

/// One row of a sparse matrix, sums over columns met in any order, in memory of a SumTable. To be held by
/// value: its count then stays in a register.
class RowSums {
 public:
  RowSums(float* sums, std::uint32_t* touched) : sums_(sums), touched_(touched) {}

  void add(std::size_t column, float value) noexcept {
    touched_[count_] = static_cast<std::uint32_t>(column);
    // No branch: it could not be predicted.
    count_ += std::bit_cast<std::uint32_t>(sums_[column]) == 0 ? 1 : 0;
    sums_[column] += value;
  }

  /// In the order of first mention. One whose sum was 0 in between comes again.
  std::span<const std::uint32_t> columns() const noexcept { return {touched_, count_}; }

  /// The sum of a column, which from here on is 0. To be called for all of columns(), so that another row can
  /// begin.
  float take(std::uint32_t column) noexcept { return std::exchange(sums_[column], 0.0F); }

 private:
  float* sums_;
  std::uint32_t* touched_;
  std::size_t count_ = 0;
};

struct SumTable {
  explicit SumTable(std::uint32_t columns) : sums(columns, 0.0F) {}

  /// `most`: what will be added.
  RowSums row(std::size_t most) {
    if (touched.size() <= most) touched.resize(2 * most + 1);
    return {sums.data(), touched.data()};
  }

  LargeVector<float> sums;
  LargeVector<std::uint32_t> touched;
};

}  // namespace deltamesh::settling
