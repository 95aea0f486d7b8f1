// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// One row of a sparse matrix at a time, from sums over columns met in any order.
#pragma once

#include <cstdint>
#include <utility>

#include "base/large_vector.h"

namespace deltamesh::multigrid {

struct Sum {
  float value = 0;
  std::uint32_t is_touched = 0;
};

/// One row of a sparse matrix, sums over columns met in any order, in memory of a SumTable. To be held by
/// value: its count then stays in a register.
class RowSums {
 public:
  RowSums(Sum* sums, std::uint32_t* touched) : sums_(sums), touched_(touched) {}

  void add(std::uint32_t column, float value) noexcept {
    Sum& sum = sums_[column];
    touched_[count_] = column;
    count_ += 1 - sum.is_touched;  // no branch: it could not be predicted
    sum.is_touched = 1;
    sum.value += value;
  }

  /// Calls take(column, sum) for every column in the order of first mention, and clears the row.
  template <class Take>
  void finish(const Take& take) {
    for (std::uint32_t k = 0; k < count_; ++k) take(touched_[k], std::exchange(sums_[touched_[k]], {}).value);
    count_ = 0;
  }

 private:
  Sum* sums_;
  std::uint32_t* touched_;
  std::uint32_t count_ = 0;
};

struct SumTable {
  explicit SumTable(std::uint32_t columns) : sums(columns, Sum{}), touched(columns + 1) {}
  RowSums row() noexcept { return {sums.data(), touched.data()}; }

  LargeVector<Sum> sums;
  LargeVector<std::uint32_t> touched;
};

}  // namespace deltamesh::multigrid
