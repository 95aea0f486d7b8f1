// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A sparse matrix in the making, row by row.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/large_vector.h"
#include "base/thread_team.h"

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

/// The rows of all parts, one part after the other.
inline SparseRows join(std::span<const SparseRows> parts) {
  SparseRows whole;
  std::vector<std::size_t> first_row(1, 0), first_entry(1, 0);
  for (const SparseRows& part : parts) {
    first_row.push_back(first_row.back() + part.row_count());
    first_entry.push_back(first_entry.back() + part.entries.size());
  }
  whole.start.resize(first_row.back() + 1);
  whole.start[0] = 0;
  whole.entries.resize(first_entry.back());
  share_work(static_cast<std::uint32_t>(parts.size()), [&](std::uint32_t p) {
    std::copy(parts[p].entries.begin(), parts[p].entries.end(),
              whole.entries.begin() + static_cast<std::ptrdiff_t>(first_entry[p]));
    for (std::size_t row = 1; row < parts[p].start.size(); ++row)
      whole.start[first_row[p] + row] = static_cast<std::uint32_t>(first_entry[p]) + parts[p].start[row];
  });
  return whole;
}

/// `fill(begin, end, rows)` adds the rows from `begin` to `end`, on any thread. That takes long: fewer rows
/// than of most other work are worth a piece.
template <class Fill>
SparseRows make_rows(std::uint32_t count, std::size_t expected_entries, const Fill& fill) {
  constexpr std::size_t kRowsInOne = 8;
  const std::uint32_t pieces = piece_count(kRowsInOne * count);
  std::vector<SparseRows> parts(pieces);
  share_work(pieces, [&](std::uint32_t p) {
    const std::uint32_t begin = piece_begin(count, pieces, p);
    const std::uint32_t end = piece_begin(count, pieces, p + 1);
    parts[p].begin(end - begin, expected_entries / pieces);
    fill(begin, end, parts[p]);
  });
  return pieces == 1 ? std::move(parts.front()) : join(parts);
}

}  // namespace deltamesh::settling
