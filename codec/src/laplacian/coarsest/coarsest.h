// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The coarsest level with its anchors: s eliminated, exact where it is small, else a fixed number of
// iterations [DELT-7].
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/memory/large_vector.h"
#include "laplacian/coarsest/conjugate_gradients.h"
#include "laplacian/coarsest/dense_factor.h"
#include "laplacian/multigrid/level/coupled_problem.h"
#include "laplacian/multigrid/level/level.h"
#include "laplacian/multigrid/level/row.h"

namespace deltamesh::multigrid {

/// Solves a coupled problem for x, s and the anchor forces f by
///   (K M^-1 K + E E^T) x = K M^-1 b.x - b.s + E g.
/// In doubles, as with few anchors the rounding errors of floats would show in the result. Memory is
/// allocated by the constructor only. O(n + edges).
class CoarsestSolver {
 public:
  /// `level` must outlive the solver. Anchor a with holds[a] = 0 is alone in its component: it only says
  /// where that is, its force is 0. `components`: as ConjugateGradients.
  CoarsestSolver(const Level& level, std::vector<std::uint8_t> holds, std::vector<std::uint32_t> components);

  /// Overwrites `u` and `forces`.
  void solve(const CoupledProblem& problem);

 private:
  Double4 row_of_k(std::uint32_t i, const LargeVector<Double4>& values) const noexcept;

  const Level& level_;
  std::vector<std::uint8_t> holds_;
  std::vector<double> inverse_mass_;
  std::optional<DenseFactor> factor_;                      ///< where there are few nodes
  std::optional<ConjugateGradients> conjugate_gradients_;  ///< where there are more
  LargeVector<Double4> x_, scaled_;
};

}  // namespace deltamesh::multigrid
