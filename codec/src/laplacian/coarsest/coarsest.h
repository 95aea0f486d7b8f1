// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The coarsest level with its anchors: s eliminated, exact where it is small, else a fixed number of
// iterations [DELT-7].
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/memory/large_vector.h"
#include "base/numbers/vec3.h"
#include "laplacian/coarsest/conjugate_gradients.h"
#include "laplacian/coarsest/envelope_factor.h"
#include "laplacian/multigrid/level/coupled_problem.h"
#include "laplacian/multigrid/level/level.h"
#include "laplacian/multigrid/level/row.h"
#include "laplacian/operator/delta_view.h"

namespace deltamesh::multigrid {

/// Solves a coupled problem for x, s and the anchor forces f by
///   (K M^-1 K + E E^T) x = K M^-1 b.x - b.s + E g.
/// In doubles, as with few anchors the rounding errors of floats would show in the result. Memory is
/// allocated by the constructor only. O(n + edges).
class CoarsestSolver {
 public:
  /// `level` must outlive the solver.
  explicit CoarsestSolver(const Level& level);

  /// Overwrites `u` and `forces`. An anchor that is the only one says where the component is, no more: its
  /// force is 0.
  void solve(const CoupledProblem& problem);

 private:
  Double4 row_of_k(std::uint32_t i, const LargeVector<Double4>& values) const noexcept;

  const Level& level_;
  std::vector<double> inverse_mass_;
  std::optional<EnvelopeFactor> factor_;                   ///< where there are few nodes
  std::optional<ConjugateGradients> conjugate_gradients_;  ///< where there are more
  LargeVector<Double4> x_, scaled_;
};

/// The least-squares solution on a finest level that is the coarsest one as well. `targets`: of the level's
/// anchors; `x`: n, overwritten; `factor`: any, overwritten. O(n w^2), w being what the rows of the factor
/// have.
void solve_directly(const Level& finest, const DeltaView& deltas, std::span<const Vec3> targets,
                    EnvelopeFactor& factor, std::span<Vec3> x);

}  // namespace deltamesh::multigrid
