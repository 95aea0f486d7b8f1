// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Sparse LDL^T of the normal equations N = L^T L + w^2 sum_a e_a e_a^T, with one step of iterative refinement
// whose residual is taken through L itself, not through N.
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <vector>

#include "laplacian/solver.h"

namespace deltamesh {
namespace {

using Index = std::int64_t;
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Index>;

/// Entry of L in row `row`, column `column`, which are equal or neighbours.
double laplacian_entry(const Adjacency& graph, std::uint32_t row, std::uint32_t column) noexcept {
  return row == column ? 1.0 : -1.0 / graph.degree(row);
}

/// Lower half of N, column by column: entry (a, b) sums L_ia L_ib over the rows i that b touches.
class NormalEquations {
 public:
  NormalEquations(const Adjacency& graph, std::span<const std::uint32_t> anchors)
      : graph_(graph), sums_(graph.vertex_count(), 0.0), seen_(graph.vertex_count(), 0) {
    is_anchor_.assign(graph.vertex_count(), 0);
    for (const std::uint32_t anchor : anchors) is_anchor_[anchor] = 1;
  }

  SparseMatrix assemble() {
    const auto n = static_cast<Index>(graph_.vertex_count());
    SparseMatrix matrix(n, n);
    matrix.reserve(static_cast<Index>(graph_.neighbors.size()) * 3 / 2 + n);
    for (std::uint32_t column = 0; column < graph_.vertex_count(); ++column) append_column(column, matrix);
    matrix.finalize();
    return matrix;
  }

 private:
  void append_column(std::uint32_t column, SparseMatrix& matrix) {
    rows_.clear();
    add_row_of_l(column, column);
    for (const std::uint32_t i : graph_.of(column)) add_row_of_l(i, column);
    if (is_anchor_[column] != 0) add(column, 1.0);  // w = 1
    std::sort(rows_.begin(), rows_.end());
    matrix.startVec(column);
    for (const std::uint32_t row : rows_) {
      matrix.insertBack(row, column) = sums_[row];
      sums_[row] = 0;
      seen_[row] = 0;
    }
  }

  /// Adds L_i,column times row i of L.
  void add_row_of_l(std::uint32_t i, std::uint32_t column) {
    const double factor = laplacian_entry(graph_, i, column);
    if (i >= column) add(i, factor);
    const double off_diagonal = factor * (-1.0 / std::max(graph_.degree(i), 1U));
    for (const std::uint32_t row : graph_.of(i)) {
      if (row >= column) add(row, off_diagonal);
    }
  }

  void add(std::uint32_t row, double value) {
    if (seen_[row] == 0) {
      seen_[row] = 1;
      rows_.push_back(row);
    }
    sums_[row] += value;
  }

  const Adjacency& graph_;
  std::vector<double> sums_;
  std::vector<std::uint8_t> seen_;
  std::vector<std::uint8_t> is_anchor_;
  std::vector<std::uint32_t> rows_;
};

class DirectSolver final : public LeastSquaresSolver {
 public:
  DirectSolver(const Adjacency& graph, std::span<const std::uint32_t> anchors)
      : graph_(graph),
        anchors_(anchors.begin(), anchors.end()),
        factors_(NormalEquations(graph, anchors).assemble()) {}

  bool succeeded() const { return factors_.info() == Eigen::Success; }

  Result<void> solve(std::span<const Vec3> deltas, std::span<const Vec3> anchor_positions,
                     std::span<Vec3> x) override {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Eigen::VectorXd solution = Eigen::VectorXd::Zero(static_cast<Index>(x.size()));
      for (int step = 0; step < 2; ++step)  // the solve and its refinement
        solution += factors_.solve(gradient(deltas, anchor_positions, solution, axis));
      for (std::size_t i = 0; i < x.size(); ++i) x[i][axis] = solution[static_cast<Index>(i)];
    }
    return {};
  }

 private:
  /// L^T (delta - L x) + w^2 sum_a (c_a - x_a) e_a, on one axis: zero at the solution.
  Eigen::VectorXd gradient(std::span<const Vec3> deltas, std::span<const Vec3> anchor_positions,
                           const Eigen::VectorXd& x, std::size_t axis) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(x.size());
    for (std::uint32_t i = 0; i < graph_.vertex_count(); ++i) {
      if (graph_.degree(i) == 0) continue;
      const double weight = 1.0 / graph_.degree(i);
      double sum = 0;
      for (const std::uint32_t j : graph_.of(i)) sum += x[j];
      const double residual = deltas[i][axis] - (x[i] - weight * sum);
      result[i] += residual;
      for (const std::uint32_t j : graph_.of(i)) result[j] -= weight * residual;
    }
    for (std::size_t a = 0; a < anchors_.size(); ++a)
      result[anchors_[a]] += anchor_positions[a][axis] - x[anchors_[a]];
    return result;
  }

  const Adjacency& graph_;
  std::vector<std::uint32_t> anchors_;
  Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::AMDOrdering<Index>> factors_;
};

}  // namespace

Result<std::unique_ptr<LeastSquaresSolver>> make_direct_solver(const Adjacency& graph,
                                                               std::span<const std::uint32_t> anchors) {
  auto solver = std::make_unique<DirectSolver>(graph, anchors);
  if (!solver->succeeded())
    return Error{.code = ErrorCode::kInvalidStream,
                 .message = "the least-squares system is singular",
                 .rule = "DELT-4"};
  return std::unique_ptr<LeastSquaresSolver>(std::move(solver));
}

}  // namespace deltamesh
