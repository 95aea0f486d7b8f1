// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Some of a graph's vertices. Where they are whole components, mostly they come in few long runs.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace deltamesh {

/// Vertices in ascending order; the i-th of them has row i.
class VertexSubset {
 public:
  /// Vertices that follow each other, begin .. end - 1.
  struct Run {
    std::uint32_t begin;
    std::uint32_t end;
    std::uint32_t row;  ///< of the first one

    std::uint32_t size() const noexcept { return end - begin; }
  };

  /// Vertices begin .. end - 1 come behind all others. At least one.
  void append(std::uint32_t begin, std::uint32_t end) {
    if (!runs_.empty() && runs_.back().end == begin) {
      runs_.back().end = end;
    } else {
      runs_.push_back({.begin = begin, .end = end, .row = static_cast<std::uint32_t>(size())});
    }
  }

  bool empty() const noexcept { return runs_.empty(); }
  std::size_t size() const noexcept {
    return empty() ? 0 : std::size_t{runs_.back().row} + runs_.back().size();
  }
  /// Ascending, with other vertices between them.
  std::span<const Run> runs() const noexcept { return runs_; }

  /// O(log runs).
  std::uint32_t vertex(std::uint32_t row) const noexcept;
  /// Nothing where the vertex is not among these. O(log runs).
  std::optional<std::uint32_t> row_of(std::uint32_t vertex) const noexcept;

 private:
  std::vector<Run> runs_;
};

/// Rows of vertices that are asked for in ascending order.
class SubsetCursor {
 public:
  explicit SubsetCursor(const VertexSubset& subset) noexcept : left_(subset.runs()) {}

  /// As VertexSubset::row_of. O(1), but for O(runs) over all calls.
  std::optional<std::uint32_t> row_of(std::uint32_t vertex) noexcept {
    while (!left_.empty() && left_.front().end <= vertex) left_ = left_.subspan(1);
    if (left_.empty() || vertex < left_.front().begin) return std::nullopt;
    return left_.front().row + (vertex - left_.front().begin);
  }

 private:
  std::span<const VertexSubset::Run> left_;
};

/// One value per row in, one per vertex out, those of other vertices as they are. O(rows).
template <class T>
void scatter_rows(std::span<const T> rows, const VertexSubset& subset, std::span<T> values) {
  for (const auto& run : subset.runs())
    std::copy_n(rows.begin() + run.row, run.size(), values.begin() + run.begin);
}

/// The same for rows at the front of `values`; those of other vertices become anything. O(rows).
template <class T>
void spread_rows(const VertexSubset& subset, std::span<T> values) {
  for (auto run = subset.runs().rbegin(); run != subset.runs().rend(); ++run) {
    if (run->row == run->begin) return;
    std::copy_backward(values.begin() + run->row, values.begin() + run->row + run->size(),
                       values.begin() + run->end);
  }
}

}  // namespace deltamesh
