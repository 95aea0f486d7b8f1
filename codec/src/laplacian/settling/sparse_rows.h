// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A sparse matrix in the making, row by row.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/large_vector.h"

namespace deltamesh::settling {

/// An entry of a sparse matrix, in the row that it is listed for.
struct Entry {
  std::uint32_t node;
  float weight;
};

struct SparseRows {
  LargeVector<std::uint32_t> start;  ///< rows + 1
  LargeVector<Entry> entries;

  std::uint32_t row_count() const noexcept { return static_cast<std::uint32_t>(start.size() - 1); }
  std::span<const Entry> of(std::uint32_t row) const noexcept {
    return {entries.data() + start[row], entries.data() + start[row + 1]};
  }

  /// Room for so many, and no rows.
  void begin(std::size_t rows, std::size_t expected_entries) {
    start.reserve(rows + 1);
    start.assign(1, 0);
    entries.reserve(expected_entries);
  }
  /// What was added to `entries` since the last is a row.
  void end_row() { start.push_back(static_cast<std::uint32_t>(entries.size())); }
};

}  // namespace deltamesh::settling
