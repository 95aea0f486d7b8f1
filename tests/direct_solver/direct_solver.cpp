// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Sparse LDL^T of the normal equations N = L^T L + w^2 sum_a e_a e_a^T, refined with residuals that are taken
// through L itself, not through N.
//
// The row of a vertex with d neighbours is a dense (d + 1) x (d + 1) block of L^T L. To keep a hub's block
// from growing with the square of d, its residual r_h = L_h x stays an unknown of its own:
//   [ N without hub rows   L_H^T ] [ x ]   [ g ]
//   [ L_H                   -I   ] [ r ] = [ 0 ]
// A tiny multiple of I added to the upper left makes that matrix quasi-definite, so that it factors in any
// order (Vanderbei 1995); the refinement takes the effect of the addition out again.
#include "direct_solver/direct_solver.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

namespace deltamesh::test {
namespace {

using Index = Eigen::Index;
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Index>;

/// Rows of L with more neighbours are hubs.
constexpr std::uint32_t kLargestPlainDegree = 64;
constexpr double kRegularization = 1e-13;

/// Refinement ends when a correction is this small against the solution, or when so many in a row have not
/// made it smaller: then rounding is all that is left. Where hubs come with few anchors, what is added to the
/// matrix makes it slow.
constexpr double kSmallCorrection = 1e-13;
constexpr double kSmaller = 0.99;
constexpr int kMostInVain = 40;

/// Entry of L in row `row`, column `column`, which are equal or neighbours.
double laplacian_entry(const Adjacency& graph, std::uint32_t row, std::uint32_t column) noexcept {
  return row == column ? 1.0 : -1.0 / graph.degree(row);
}

/// Lower half of the matrix above, column by column: entry (a, b) of N sums L_ia L_ib over the plain rows i
/// that b touches; below them a row for every hub.
class NormalEquations {
 public:
  NormalEquations(const Adjacency& graph, std::span<const std::uint32_t> anchors)
      : graph_(graph), is_anchor_(graph.vertex_count(), 0), hub_row_(graph.vertex_count(), 0) {
    for (const std::uint32_t anchor : anchors) is_anchor_[anchor] = 1;
    size_ = static_cast<std::uint32_t>(graph.vertex_count());
    for (std::uint32_t v = 0; v < graph.vertex_count(); ++v) {
      if (graph.degree(v) > kLargestPlainDegree) hub_row_[v] = size_++;
    }
    sums_.assign(size_, 0.0);
    seen_.assign(size_, 0);
  }

  SparseMatrix assemble() {
    const auto vertex_count = static_cast<std::uint32_t>(graph_.vertex_count());
    SparseMatrix matrix(size_, size_);
    matrix.reserve(static_cast<Index>(graph_.neighbors.size()) * 3 / 2 + size_);
    for (std::uint32_t column = 0; column < vertex_count; ++column) append_column(column, matrix);
    for (std::uint32_t column = vertex_count; column < size_; ++column) {
      matrix.startVec(column);
      matrix.insertBack(column, column) = -1.0;
    }
    matrix.finalize();
    return matrix;
  }

 private:
  void append_column(std::uint32_t column, SparseMatrix& matrix) {
    rows_.clear();
    add_row_of_l(column, column);
    for (const std::uint32_t i : graph_.of(column)) add_row_of_l(i, column);
    if (is_anchor_[column] != 0) add(column, 1.0);  // w = 1
    if (size_ > graph_.vertex_count()) add(column, kRegularization);
    std::sort(rows_.begin(), rows_.end());
    matrix.startVec(column);
    for (const std::uint32_t row : rows_) {
      matrix.insertBack(row, column) = sums_[row];
      sums_[row] = 0;
      seen_[row] = 0;
    }
  }

  /// Adds L_i,column times row i of L; a hub's L_i,column goes to the row of its own.
  void add_row_of_l(std::uint32_t i, std::uint32_t column) {
    const double factor = laplacian_entry(graph_, i, column);
    if (hub_row_[i] != 0) return add(hub_row_[i], factor);
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
  std::vector<std::uint8_t> is_anchor_;
  std::vector<std::uint32_t> hub_row_;  ///< 0 where the vertex is no hub
  std::uint32_t size_ = 0;              ///< vertices and hubs
  std::vector<double> sums_;
  std::vector<std::uint8_t> seen_;
  std::vector<std::uint32_t> rows_;
};

}  // namespace

class DirectSolver::Factors {
 public:
  Factors(const Adjacency& graph, std::span<const std::uint32_t> anchors)
      : graph_(graph),
        anchors_(anchors.begin(), anchors.end()),
        factors_(NormalEquations(graph, anchors).assemble()) {
    if (factors_.info() != Eigen::Success) std::abort();
  }

  void solve(const DeltaView& deltas, std::span<const Vec3> anchor_positions, std::span<Vec3> x) const {
    const auto n = static_cast<Index>(x.size());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Eigen::VectorXd solution = Eigen::VectorXd::Zero(n);
      double smallest = std::numeric_limits<double>::infinity();
      for (int in_vain = 0; in_vain < kMostInVain; ++in_vain) {
        const Eigen::VectorXd correction =
            factors_.solve(gradient(deltas, anchor_positions, solution, axis)).head(n);
        solution += correction;
        const double size = largest(correction);
        if (!(size > kSmallCorrection * largest(solution))) break;
        if (size > kSmaller * smallest) continue;
        smallest = size;
        in_vain = 0;
      }
      for (std::size_t i = 0; i < x.size(); ++i) x[i][axis] = solution[static_cast<Index>(i)];
    }
  }

 private:
  /// L^T (delta - L x) + w^2 sum_a (c_a - x_a) e_a, on one axis: zero at the solution. Zeros follow for
  /// the hubs.
  Eigen::VectorXd gradient(const DeltaView& deltas, std::span<const Vec3> anchor_positions,
                           const Eigen::VectorXd& x, std::size_t axis) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(factors_.rows());
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

  /// In plain order, for the same result on every machine.
  static double largest(const Eigen::VectorXd& values) noexcept {
    double result = 0;
    for (const double value : values) result = std::max(result, std::abs(value));
    return result;
  }

  const Adjacency& graph_;
  std::vector<std::uint32_t> anchors_;
  Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::AMDOrdering<Index>> factors_;
};

DirectSolver::DirectSolver(const Adjacency& graph, std::span<const std::uint32_t> anchors)
    : factors_(std::make_unique<const Factors>(graph, anchors)) {}

DirectSolver::~DirectSolver() = default;

void DirectSolver::solve(const DeltaView& deltas, std::span<const Vec3> anchor_positions,
                         std::span<Vec3> x) const {
  factors_->solve(deltas, anchor_positions, x);
}

}  // namespace deltamesh::test
