// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The coarsest level with its anchors: s eliminated, solved by conjugate gradients.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "laplacian/multigrid_level.h"

namespace deltamesh::multigrid {

/// Solves  K x + M s = b_x,  K s - E f = b_s,  x_a - f_a = g_a  (w = 1) for x, s and the anchor forces f, by
/// way of (K M^-1 K + E E^T) x = K M^-1 b_x - b_s + E g, preconditioned by symmetric Gauss-Seidel, until the
/// residual has fallen by kReduction on every axis. Memory is allocated at setup only.
class CoarsestSolver {
 public:
  /// `level` must outlive the solver.
  explicit CoarsestSolver(const Level& level);

  /// `b`, `u`: n; `gaps`: g; `forces`: f, both one per anchor.
  void solve(std::span<const Row> b, std::span<const Float4> gaps, std::span<Row> u,
             std::span<Float4> forces);

 private:
  void assemble();
  Float4 apply_k(std::span<const Float4> values, std::uint32_t node) const noexcept;
  void apply_matrix(std::span<const Float4> in, std::span<Float4> out) const noexcept;
  void precondition() noexcept;
  void run_conjugate_gradients() noexcept;

  const Level& level_;
  std::vector<std::uint32_t> offsets_;  ///< rows of the matrix without its diagonal, columns ascending
  std::vector<std::uint32_t> columns_;
  std::vector<float> values_;
  std::vector<float> diagonal_;
  std::vector<float> inverse_diagonal_;
  std::vector<std::uint32_t> split_;  ///< first entry of a row beyond the diagonal
  std::vector<Float4> scaled_;        ///< M^-1 b_x
  std::vector<Float4> x_, residual_, direction_, product_, preconditioned_;
};

}  // namespace deltamesh::multigrid
