// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The coarsest level with its anchors: s eliminated, solved in doubles.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/large_vector.h"
#include "laplacian/settling/conjugate_gradients.h"
#include "laplacian/settling/factor.h"
#include "laplacian/settling/level.h"

namespace deltamesh::settling {

struct CoarsestEffort {
  std::uint32_t largest_factored = 0;  ///< nodes; larger levels are left to conjugate gradients
  double reduction = 0;                ///< of the residual where those stop
};

/// Solves  K x + M s = b_x,  K s - E f = b_s,  x_a - f_a = g_a  (w = 1) for x, s and the anchor forces f, by
/// way of (K M^-1 K + E E^T) x = K M^-1 b_x - b_s + E g: factored where there are few nodes
/// and no hubs, else by conjugate gradients with symmetric Gauss-Seidel, which never form the matrix,
/// until the residual has fallen enough. Memory is allocated at setup only. Memory and
/// the time of an iteration: O(n + edges).
class CoarsestSolver {
 public:
  /// `level` and `holds` must outlive the solver. Anchor a with holds[a] = 0 is alone in its component: it
  /// only says where that is, its force is 0.
  CoarsestSolver(const Level& level, std::span<const std::uint8_t> holds, CoarsestEffort effort);

  /// `b`, `u`: n; `gaps`: g; `forces`: f, both one per anchor.
  /// Conjugate gradients end after `most_iterations` at the latest. Returns how many were made.
  std::uint32_t solve(std::span<const Row> b, std::span<const Float4> gaps, std::span<Row> u,
                      std::span<Float4> forces, std::uint32_t most_iterations);

 private:
  /// Whether the matrix can be formed in time and memory linear in n.
  bool product_stays_sparse() const noexcept;
  SymmetricMatrix assemble() const;

  const Level& level_;
  std::span<const std::uint8_t> holds_;
  std::optional<SparseFactor> factor_;
  std::vector<double> inverse_mass_;
  std::vector<std::uint8_t> is_anchor_;
  LargeVector<Double4> scaled_;  ///< M^-1 b_x
  LargeVector<Double4> x_;
  std::unique_ptr<ConjugateGradients> conjugate_gradients_;  ///< where there is no factor
};

}  // namespace deltamesh::settling
