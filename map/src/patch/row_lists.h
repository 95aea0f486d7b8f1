// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Rows found by what they hold: three numbers, or a place nearby.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "base/numbers/vec3.h"

namespace deltamesh {

inline constexpr std::uint32_t kNoRow = std::numeric_limits<std::uint32_t>::max();

inline std::uint64_t row_hash(const std::array<std::uint32_t, 3>& numbers) noexcept {
  std::uint64_t hash = 0;
  for (const std::uint32_t n : numbers) hash = (hash ^ n) * 0x9e3779b97f4a7c15U;
  return hash ^ hash >> 32;
}

/// Lists of rows by hash.
class RowLists {
 public:
  explicit RowLists(std::size_t rows) : first_(std::bit_ceil(rows + 1), kNoRow), next_(rows, kNoRow) {}

  void add(std::uint64_t hash, std::uint32_t row) {
    std::uint32_t& first = first_[hash & (first_.size() - 1)];
    next_[row] = std::exchange(first, row);
  }
  /// All rows of the hash, and perhaps others, descending where they were added ascending.
  std::uint32_t first(std::uint64_t hash) const noexcept { return first_[hash & (first_.size() - 1)]; }
  std::uint32_t next(std::uint32_t row) const noexcept { return next_[row]; }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> next_;
};

/// Finds the vertex nearest to a place within a radius.
class NearRows {
 public:
  NearRows(std::span<const float> positions, double radius)
      : positions_(positions), edge_(2 * radius), cells_(positions.size() / 3) {
    for (std::uint32_t v = 0; v < positions.size() / 3; ++v) {
      std::array<std::uint32_t, 3> cell{};
      for (std::size_t k = 0; k < 3; ++k) cell[k] = step_of(double{positions_[3 * std::size_t{v} + k]});
      cells_.add(row_hash(cell), v);
    }
  }

  std::uint32_t nearest(const float* place) const noexcept {
    std::uint32_t best = kNoRow;
    double least = edge_ * edge_ / 4;
    std::array<std::uint32_t, 3> low{};
    for (std::size_t k = 0; k < 3; ++k) low[k] = step_of(double{place[k]} - edge_ / 2);
    for (unsigned corner = 0; corner < 8; ++corner) {
      std::array<std::uint32_t, 3> cell = low;
      for (std::size_t k = 0; k < 3; ++k) cell[k] += corner >> k & 1U;
      for (std::uint32_t v = cells_.first(row_hash(cell)); v != kNoRow; v = cells_.next(v)) {
        const double squared = squared_distance(place, positions_.data() + 3 * std::size_t{v});
        if (squared < least || (squared == least && v < best)) {
          least = squared;
          best = v;
        }
      }
    }
    return best;
  }

 private:
  std::uint32_t step_of(double x) const noexcept {
    return static_cast<std::uint32_t>(
        static_cast<std::int32_t>(std::clamp(std::floor(x / edge_), -2e9, 2e9)));
  }

  std::span<const float> positions_;
  double edge_;
  RowLists cells_;
};

}  // namespace deltamesh
