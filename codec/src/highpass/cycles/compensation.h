// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Positions that make up for what planned cycles leave out [DELT-7].
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/numbers/vec3.h"
#include "deltamesh/result.h"
#include "highpass/cycles/plan.h"
#include "laplacian/operator/solved_part.h"
#include "laplacian/solver.h"

namespace deltamesh {

/// Positions y whose deltas and anchors, neither of them rounded, a given number of planned cycles turns into
/// the positions x of a mesh: with B y for what the cycles make of y, y <- y + (x - B y). That converges as
/// fast as B does, by a hundred times each time where there are two cycles. L (y - x) being small against any
/// step that is worth coding, rounding the deltas of y leaves the noise that rounding those of x would, of
/// which B passes hardly more than the exact solution does: where deltas are rough enough to be dithered by
/// rounding, y costs no bits. Flat regions, all zeros, lose what is below half a step (FlatDeltas).
class Compensation {
 public:
  /// y = x. `part` and `positions` (x: n, of the whole graph) must outlive this. `center`: what the solver's
  /// coordinates are relative to; `anchors`: where anchors can be coded. O(n + edges).
  Compensation(const SolvedPart& part, std::span<const Vec3> positions, const Vec3& center,
               const Box& anchors);

  /// One step. `solver`: of the part; `anchors`: rows, ascending. Returns x - B y of y as it was. Errors as
  /// PlannedSolver::solve(), and kInvalidStream where the cycles diverge; y stays then. Cost: a solve.
  Result<PlanErrors> improve(PlannedSolver& solver, std::span<const std::uint32_t> anchors, int cycles);

  /// Calls look(cycles, x - B y), over rows, for 1, 2, 3... cycles, until it returns false. Errors and cost:
  /// as PlannedSolver::follow().
  Result<void> follow(PlannedSolver& solver, std::span<const std::uint32_t> anchors,
                      const PlannedSolver::Look& look) const;

  /// n: y. What does not belong to the part is as it was.
  std::span<const Vec3> positions() const noexcept { return shifted_; }
  /// Rows: L y.
  std::span<const Vec3> deltas() const noexcept { return deltas_; }

 private:
  /// In units, relative to the centre.
  struct Problem {
    std::vector<Vec3> deltas;
    std::vector<Vec3> targets;
  };
  Problem problem(std::span<const std::uint32_t> anchors) const;
  /// x - B y at a row. `found`: there, by a solver.
  Vec3 left_out(std::uint32_t row, const Vec3& found) const noexcept {
    return positions_[part_->vertex(row)] - (center_ + unit_ * found);
  }

  const SolvedPart* part_;
  std::span<const Vec3> positions_;
  Vec3 center_;
  Box box_;      ///< of anchors
  double unit_;  ///< model units, a power of 2: in it the mesh is of a size that suits floats
  std::vector<Vec3> shifted_;
  std::vector<Vec3> deltas_;
};

}  // namespace deltamesh
