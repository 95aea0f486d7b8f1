// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid_factor.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

namespace deltamesh::multigrid {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;
using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;
using Factors = Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<int>>;

/// Bounds of the factor's entries and of the work, which is the sum of the squares of its columns' counts,
/// per column. Meshes of 100,000 vertices stay below 150 and 200,000; graphs made to hurt would fill the
/// whole matrix.
constexpr std::uint64_t kMostEntriesPerColumn = 400;
constexpr std::uint64_t kMostEntries = std::uint64_t{1} << 25;
constexpr std::uint64_t kMostWorkPerColumn = 400000;

/// The lower half, column by column, of the matrix with row i at place[i].
SparseMatrix lower_half(const SymmetricMatrix& matrix, std::span<const std::uint32_t> place) {
  const std::uint32_t n = matrix.size();
  LargeVector<Eigen::Triplet<double, int>> entries;
  entries.reserve(matrix.columns.size() / 2 + n);
  for (std::uint32_t i = 0; i < n; ++i) {
    const auto column = static_cast<int>(place[i]);
    entries.emplace_back(column, column, matrix.diagonal[i]);
    for (std::uint32_t e = matrix.offsets[i]; e < matrix.offsets[i + 1]; ++e) {
      const auto row = static_cast<int>(place[matrix.columns[e]]);
      if (row > column) entries.emplace_back(row, column, matrix.values[e]);
    }
  }
  SparseMatrix lower(static_cast<int>(n), static_cast<int>(n));
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

/// Minimum degree.
std::vector<std::uint32_t> choose_places(const SymmetricMatrix& matrix) {
  std::vector<std::uint32_t> identity(matrix.size());
  std::iota(identity.begin(), identity.end(), 0U);
  Permutation order;
  Eigen::AMDOrdering<int>()(lower_half(matrix, identity).selfadjointView<Eigen::Lower>(), order);
  std::vector<std::uint32_t> place(matrix.size());
  for (std::uint32_t k = 0; k < place.size(); ++k) place[static_cast<std::uint32_t>(order.indices()[k])] = k;
  return place;
}

/// Counts the entries that L will have, by walking the elimination tree up from every entry of a row (Davis,
/// Direct Methods for Sparse Linear Systems, 4.2), and gives up beyond the limits.
bool stays_sparse(const SymmetricMatrix& matrix, std::span<const std::uint32_t> place) {
  const std::uint32_t n = matrix.size();
  const std::uint32_t none = n;
  std::vector<std::uint32_t> row_at(n), parent(n, none), seen(n, none);
  for (std::uint32_t i = 0; i < n; ++i) row_at[place[i]] = i;
  std::vector<std::uint64_t> count(n, 0);  // of a column
  const std::uint64_t most_entries = std::min(kMostEntriesPerColumn * n, kMostEntries);
  std::uint64_t entries = 0;
  std::uint64_t work = 0;
  for (std::uint32_t k = 0; k < n; ++k) {
    seen[k] = k;
    const std::uint32_t i = row_at[k];
    for (std::uint32_t e = matrix.offsets[i]; e < matrix.offsets[i + 1]; ++e) {
      for (std::uint32_t j = place[matrix.columns[e]]; j < k && seen[j] != k; j = parent[j]) {
        if (parent[j] == none) parent[j] = k;
        seen[j] = k;
        ++entries;
        work += 2 * count[j]++ + 1;  // the difference of squares
      }
    }
    if (entries > most_entries || work > kMostWorkPerColumn * n) return false;
  }
  return true;
}

}  // namespace

std::optional<SparseFactor> SparseFactor::make(const SymmetricMatrix& matrix) {
  std::vector<std::uint32_t> place = choose_places(matrix);
  if (!stays_sparse(matrix, place)) return std::nullopt;
  const Factors factors(lower_half(matrix, place));
  if (factors.info() != Eigen::Success) return std::nullopt;
  const std::uint32_t n = matrix.size();
  const SparseMatrix& lower = factors.matrixL().nestedExpression();
  const Eigen::VectorXd pivots = factors.vectorD();  // a copy each time it is asked for
  SparseFactor result;
  result.offsets_.assign(1, 0);
  for (std::uint32_t column = 0; column < n; ++column) {
    if (!(pivots[column] > 0)) return std::nullopt;
    result.inverse_diagonal_.push_back(1 / pivots[column]);
    for (SparseMatrix::InnerIterator entry(lower, column); entry; ++entry) {
      if (static_cast<std::uint32_t>(entry.row()) == column) continue;
      result.rows_.push_back(static_cast<std::uint32_t>(entry.row()));
      result.values_.push_back(entry.value());
    }
    result.offsets_.push_back(static_cast<std::uint32_t>(result.rows_.size()));
  }
  result.place_ = std::move(place);
  result.work_.resize(n);
  return result;
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

}  // namespace deltamesh::multigrid
