// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The loss of quality by planned cycles in place of settling, and its compensation [DELT-7].
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/numbers/vec3.h"
#include "deltamesh/result.h"
#include "laplacian/operator/solved_part.h"
#include "laplacian/solver.h"

namespace deltamesh {

/// Largest number of planned cycles that the encoder tries; if none serves, the stream has 0, which stands
/// for the least-squares solution [DELT-4]. A choice of the encoder: streams may have up to kMostCycles.
inline constexpr int kMostCyclesTried = 8;

/// Quantised deltas of streams with planned cycles are smaller than this in size [DELT-7].
inline constexpr std::int32_t kLargestPlannedSymbol = 1 << 23;

/// Errors of a plan's positions over those of settled ones, the least-squares solution [DELT-4]: how far they
/// are from the true ones, rms and at most, and rms of the delta coordinates' errors, which is what the eye
/// sees.
struct PlanCost {
  double rms = 0;
  double largest = 0;
  double roughness = 0;

  /// Hardly more than 1 each.
  bool is_fair() const noexcept { return rms <= 1.019 && largest <= 1.02 && roughness <= 1.0125; }
  /// Whether other roundings of the same may be fair: the largest error is one vertex's.
  bool is_close() const noexcept { return rms <= 1.1 && roughness <= 1.03; }
};

class PlanJudge {
 public:
  /// `positions`, `settled`: n, of the whole graph. `part` and `positions` must outlive this. `invisible`:
  /// model units that nobody would see, which cost nothing. Over the rows of `part`, at least one.
  /// O(n + edges).
  PlanJudge(const SolvedPart& part, std::span<const Vec3> positions, std::span<const Vec3> settled,
            double invisible);

  /// `solution`: n. O(n + edges).
  PlanCost cost(std::span<const Vec3> solution) const;

 private:
  const SolvedPart& part_;
  std::span<const Vec3> positions_;
  double invisible_;
  PlanCost settled_;  ///< model units
};

/// Positions y whose deltas and anchors, neither of them rounded, a given number of planned cycles turns into
/// the positions x of a mesh: with B y for what the cycles make of y, y <- y + (x - B y), from y = x. That
/// converges as fast as B does, by a hundred times each time where there are two cycles. L (y - x) being
/// small against any step that is worth coding, rounding the deltas of y leaves the noise that rounding those
/// of x would, of which B passes hardly more than the exact solution does: where deltas are rough enough to
/// be dithered by rounding, y costs no bits. Flat regions, all zeros, lose what is below half a step.
class Compensation {
 public:
  /// y = x. `part` and `positions` (x: n, of the whole graph) must outlive this. `center`: what the solver's
  /// coordinates are relative to. O(n + edges).
  Compensation(const SolvedPart& part, std::span<const Vec3> positions, const Vec3& center);

  /// One step. `solver`: of the part; `anchors`: rows, ascending. Errors as LeastSquaresSolver::solve, and
  /// kInvalidStream where the cycles diverge; y is as it was then. Cost: a solve.
  Result<void> improve(LeastSquaresSolver& solver, std::span<const std::uint32_t> anchors, int cycles);

  /// n: y. What does not belong to the part is as it was.
  std::span<const Vec3> positions() const noexcept { return shifted_; }
  /// Rows: L y.
  std::span<const Vec3> deltas() const noexcept { return deltas_; }

 private:
  const SolvedPart& part_;
  std::span<const Vec3> positions_;
  Vec3 center_;
  double unit_;  ///< model units, a power of 2: in it the mesh is of a size that suits floats
  std::vector<Vec3> shifted_;
  std::vector<Vec3> deltas_;
};

}  // namespace deltamesh
