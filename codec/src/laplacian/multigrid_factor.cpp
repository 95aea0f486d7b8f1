// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid_factor.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace deltamesh::multigrid {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;
using Factors = Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::AMDOrdering<int>>;

SparseMatrix lower_half(const SymmetricMatrix& matrix) {
  const std::uint32_t n = matrix.size();
  SparseMatrix lower(n, n);
  lower.reserve(static_cast<Eigen::Index>(matrix.columns.size() / 2 + n));
  for (std::uint32_t i = 0; i < n; ++i) {
    lower.startVec(i);
    lower.insertBack(i, i) = matrix.diagonal[i];
    for (std::uint32_t e = matrix.offsets[i]; e < matrix.offsets[i + 1]; ++e) {
      if (matrix.columns[e] > i) lower.insertBack(matrix.columns[e], i) = matrix.values[e];
    }
  }
  lower.finalize();
  return lower;
}

}  // namespace

std::optional<SparseFactor> SparseFactor::make(const SymmetricMatrix& matrix) {
  const Factors factors(lower_half(matrix));
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
  result.place_.resize(n);
  for (std::uint32_t i = 0; i < n; ++i)
    result.place_[i] = static_cast<std::uint32_t>(factors.permutationP().indices()[i]);
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
