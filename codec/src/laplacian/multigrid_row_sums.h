// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// One row of a sparse matrix at a time, from sums over columns met in any order.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/large_vector.h"

namespace deltamesh::multigrid {

/// One row of a sparse matrix, sums over columns met in any order, in memory of a SumTable. To be held by
/// value: its count then stays in a register.
class RowSums {
 public:
  RowSums(float* sums, std::uint32_t* touched) : sums_(sums), touched_(touched) {}

  void add(std::uint32_t column, float value) noexcept {
    float& sum = sums_[column];
    touched_[count_] = column;
    count_ += std::bit_cast<std::uint32_t>(sum) == 0 ? 1 : 0;  // no branch: it could not be predicted
    sum += value;
  }

  /// From here on the column's sum is 0.
  void clear(std::uint32_t column) noexcept { sums_[column] = 0; }

  /// Calls take(column, sum) for every column in the order of first mention, and clears the row. A sum that
  /// was 0 in between comes again, as 0.
  template <class Take>
  void finish(const Take& take) {
    for (std::size_t k = 0; k < count_; ++k) take(touched_[k], std::exchange(sums_[touched_[k]], 0.0F));
    count_ = 0;
  }

  /// As many as finish() will call for.
  std::size_t count() const noexcept { return count_; }

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

}  // namespace deltamesh::multigrid
