// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/factor.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

namespace deltamesh::settling {
namespace {

/// Bounds of the factor's entries and of the work, which is the sum of the squares of its columns' counts:
/// some 200 megabytes, and one to three seconds. Meshes of 60,000 vertices stay below.
constexpr std::uint64_t kMostEntries = std::uint64_t{1} << 24;
constexpr std::uint64_t kMostFactorWork = std::uint64_t{1} << 32;

std::vector<std::uint32_t> invert(std::span<const std::uint32_t> place) {
  std::vector<std::uint32_t> row_at(place.size());
  for (std::uint32_t i = 0; i < place.size(); ++i) row_at[place[i]] = i;
  return row_at;
}

/// Of the columns of L, by place.
struct EliminationTree {
  std::vector<std::uint32_t> parent;  ///< n: none
  std::vector<std::uint32_t> count;   ///< entries below the diagonal
};

/// Walks the tree up from every entry of a row (Davis, Direct Methods for Sparse Linear Systems, 4.2), and
/// gives up beyond the limits.
std::optional<EliminationTree> plan_elimination(const SymmetricMatrix& matrix,
                                                std::span<const std::uint32_t> place,
                                                std::uint64_t& work_left) {
  const std::uint32_t n = matrix.size();
  const std::vector<std::uint32_t> row_at = invert(place);
  EliminationTree tree{.parent = std::vector<std::uint32_t>(n, n), .count = std::vector<std::uint32_t>(n, 0)};
  std::vector<std::uint32_t> seen(n, n);
  std::uint64_t entries = 0;
  const std::uint64_t fewest_left = work_left - std::min(work_left, kMostFactorWork);
  for (std::uint32_t k = 0; k < n; ++k) {
    seen[k] = k;
    const std::uint32_t i = row_at[k];
    std::uint64_t work = 0;
    for (std::uint32_t e = matrix.offsets[i]; e < matrix.offsets[i + 1]; ++e) {
      for (std::uint32_t j = place[matrix.columns[e]]; j < k && seen[j] != k; j = tree.parent[j]) {
        if (tree.parent[j] == n) tree.parent[j] = k;
        seen[j] = k;
        ++entries;
        work += 2 * std::uint64_t{tree.count[j]++} + 1;  // the difference of squares
      }
    }
    const bool is_possible = entries <= kMostEntries && work <= work_left - fewest_left;
    work_left -= std::min(work, work_left - fewest_left);
    if (!is_possible) return std::nullopt;
  }
  return tree;
}

struct FactorEntry {
  std::uint32_t column;
  double value;
};

/// Entries before the diagonal, all by place, row after row in ascending order of column.
struct LowerRows {
  std::vector<std::uint32_t> offsets;  ///< n + 1
  LargeVector<FactorEntry> entries;

  std::span<const FactorEntry> row(std::uint32_t k) const noexcept {
    return std::span(entries).subspan(offsets[k], offsets[k + 1] - offsets[k]);
  }
};

/// Each entry as the row after its diagonal has it: the two halves may differ by rounding.
LowerRows lower_rows(const SymmetricMatrix& matrix, std::span<const std::uint32_t> place,
                     std::span<const std::uint32_t> row_at) {
  const std::uint32_t n = matrix.size();
  const auto for_each_later = [&](std::uint32_t k, const auto& take) {
    for (std::uint32_t e = matrix.offsets[row_at[k]]; e < matrix.offsets[row_at[k] + 1]; ++e) {
      const std::uint32_t row = place[matrix.columns[e]];
      if (row > k) take(row, matrix.values[e]);
    }
  };
  LowerRows rows{.offsets = std::vector<std::uint32_t>(n + 1, 0), .entries = {}};
  for (std::uint32_t k = 0; k < n; ++k)
    for_each_later(k, [&](std::uint32_t row, double) { ++rows.offsets[row + 1]; });
  std::partial_sum(rows.offsets.begin(), rows.offsets.end(), rows.offsets.begin());
  rows.entries.resize(rows.offsets.back());
  std::vector<std::uint32_t> end(rows.offsets.begin(), rows.offsets.end() - 1);
  for (std::uint32_t k = 0; k < n; ++k)
    for_each_later(k, [&](std::uint32_t row, double value) { rows.entries[end[row]++] = {k, value}; });
  return rows;
}

}  // namespace

std::optional<SparseFactor> SparseFactor::make(const SymmetricMatrix& matrix,
                                               std::vector<std::uint32_t> place, std::uint64_t& work_left) {
  SparseFactor result;
  result.place_ = std::move(place);
  const auto tree = plan_elimination(matrix, result.place_, work_left);
  if (!tree) return std::nullopt;
  result.offsets_.assign(matrix.size() + 1, 0);
  std::partial_sum(tree->count.begin(), tree->count.end(), result.offsets_.begin() + 1);
  result.rows_.resize(result.offsets_.back());
  result.values_.resize(result.offsets_.back());
  if (!result.factor(matrix, tree->parent)) return std::nullopt;
  result.work_.resize(matrix.size());
  return result;
}

/// Row by row of L, each by solving with the rows before it, in the order of the tree (Davis, 4.8).
bool SparseFactor::factor(const SymmetricMatrix& matrix, std::span<const std::uint32_t> parent) {
  const std::uint32_t n = matrix.size();
  const std::vector<std::uint32_t> row_at = invert(place_);
  std::vector<std::uint32_t> end(offsets_.begin(), offsets_.end() - 1);  // of what is known of a column
  std::vector<std::uint32_t> seen(n, n), pattern(n);
  std::vector<double> y(n, 0.0), pivots(n);
  const LowerRows lower = lower_rows(matrix, place_, row_at);
  for (std::uint32_t k = 0; k < n; ++k) {
    seen[k] = k;
    std::uint32_t top = n;  // where in the pattern the entries of y begin that are not 0
    for (const FactorEntry& entry : lower.row(k)) {
      y[entry.column] += entry.value;
      std::uint32_t length = 0;
      for (std::uint32_t j = entry.column; seen[j] != k; j = parent[j]) {
        pattern[length++] = j;
        seen[j] = k;
      }
      while (length > 0) pattern[--top] = pattern[--length];
    }
    double pivot = matrix.diagonal[row_at[k]];
    for (; top < n; ++top) {
      const std::uint32_t j = pattern[top];
      const double y_j = std::exchange(y[j], 0.0);
      for (std::uint32_t e = offsets_[j]; e < end[j]; ++e) y[rows_[e]] -= values_[e] * y_j;
      const double entry = y_j / pivots[j];
      pivot -= entry * y_j;
      rows_[end[j]] = k;
      values_[end[j]++] = entry;
    }
    if (!(std::abs(pivot) > 0)) return false;
    pivots[k] = pivot;
    inverse_diagonal_.push_back(1 / pivot);
  }
  return true;
}

void SparseFactor::solve(std::span<Double4> b) {
  const auto n = static_cast<std::uint32_t>(b.size());
  for (std::uint32_t i = 0; i < n; ++i) work_[place_[i]] = b[i];
  for (std::uint32_t column = 0; column < n; ++column) {
    const Double4 value = work_[column];
    for (std::uint32_t e = offsets_[column]; e < offsets_[column + 1]; ++e)
      work_[rows_[e]] -= values_[e] * value;
  }
  for (std::uint32_t column = n; column-- > 0;) {
    Double4 value = inverse_diagonal_[column] * work_[column];
    for (std::uint32_t e = offsets_[column]; e < offsets_[column + 1]; ++e)
      value -= values_[e] * work_[rows_[e]];
    work_[column] = value;
  }
  for (std::uint32_t i = 0; i < n; ++i) b[i] = work_[place_[i]];
}

}  // namespace deltamesh::settling
