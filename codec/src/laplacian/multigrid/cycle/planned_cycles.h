// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Planned cycles: a given number of multigrid cycles, each as cheap as possible. The finest level has
// positions only, the residual field starts on the second level [DELT-7].
#pragma once

#include <span>
#include <vector>

#include "base/memory/large_vector.h"
#include "base/numbers/vec3.h"
#include "laplacian/multigrid/cycle/level_solver.h"
#include "laplacian/multigrid/cycle/units.h"
#include "laplacian/multigrid/level/level.h"
#include "laplacian/operator/delta_view.h"

namespace deltamesh::multigrid {

struct PlannedSolution {
  Units units;
  LargeVector<Counts> counts;  ///< n

  /// `x`: n, model units.
  void write(std::span<Vec3> x, ThreadTeam* team) const;
};

/// The coupled problem with s = P s_c interpolated from the second level: away from the anchors s is
/// harmonic, hence smooth. Few cycles leave much of the exact solution's low frequencies out; an encoder
/// makes up for it by the deltas and anchors that it codes (highpass/cycles). x is kept in whole
/// numbers; corrections are floats, in steps of the deltas.
class PlannedCycles {
 public:
  /// `levels`: at least two; must outlive this; `team`: as LevelSolver.
  PlannedCycles(std::span<const Level> levels, ThreadTeam* team);

  /// `targets`: c_a, one for each anchor; `cycles`: above 0. The result is anything, also not finite, where
  /// that is not what the deltas were made for. O(cycles (n + edges)).
  /// `watch`: null but for encoders; told of what must be in the range of 32 bits.
  PlannedSolution solve(const DeltaView& deltas, std::span<const Vec3> targets, int cycles,
                        RangeWatch* watch);

  /// The same cycle by cycle, always with the same `deltas` and `targets`: first start(), then cycle(). O(n +
  /// edges) each.
  void start(const DeltaView& deltas, std::span<const Vec3> targets, RangeWatch* watch);
  void cycle(const DeltaView& deltas, std::span<const Vec3> targets);
  /// The solution if no more cycles follow; they may.
  PlannedSolution solution_so_far(const DeltaView& deltas);

 private:
  PlannedSolution finish(const DeltaView& deltas);
  template <bool kIsWatched>
  void sweep_finest(const DeltaView& deltas, std::span<const float> relaxation);
  void sweep_finest(const DeltaView& deltas, std::span<const float> relaxation);
  void add_correction();
  void correct();
  void solve_second();

  const Level& finest_;
  const Level& second_;
  LevelSolver coarse_;
  Units units_{DeltaView{}, 0};
  LargeVector<Counts> x_;       ///< finest level; none once it is solved
  LargeVector<Float4> step_;    ///< finest level: what the last sweep added, and a 0
  LargeVector<Float4> s_;       ///< second level
  std::vector<Float4> forces_;  ///< one for each anchor
  RangeWatch* watch_ = nullptr;
  ThreadTeam* team_;
};

}  // namespace deltamesh::multigrid
