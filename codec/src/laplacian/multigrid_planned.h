// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// So many cycles as the deltas were made for, each as cheap as it can be: on the finest level, and mostly on
// the second, there are positions only, the residual field begins below.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/large_vector.h"
#include "base/vec3.h"
#include "laplacian/delta_view.h"
#include "laplacian/multigrid_level.h"
#include "laplacian/multigrid_level_solver.h"
#include "laplacian/multigrid_units.h"
#include "topology/adjacency.h"

namespace deltamesh::multigrid {

struct PlannedSolution {
  Units units;
  LargeVector<Counts> counts;  ///< n

  /// `x`: n, model units.
  void write(std::span<Vec3> x) const;
};

/// The same mixed problem as MultigridCycle's, with s = P s_c interpolated from level c, the third (the
/// second where there are but two, or anchors are many): away from the anchors s is harmonic, hence smooth.
/// Few cycles leave much of the exact solution's low frequencies out; an encoder makes up for it by the
/// deltas and anchors that it codes (geometry/compensation.h). x is kept in whole numbers; corrections are
/// floats, in steps of the deltas.
class PlannedCycles {
 public:
  /// `levels`: at least two; must outlive this; `holds`: of shared_components.
  PlannedCycles(std::span<const Level> levels, std::vector<std::uint8_t> holds,
                std::uint32_t component_count);

  /// `targets`: c_a, one for each anchor; `cycles`: above 0. The result is anything, also not finite, where
  /// that is not what the deltas were made for. O(cycles (n + edges)).
  PlannedSolution solve(const DeltaView& deltas, std::span<const Vec3> targets, int cycles);

 private:
  void start(const DeltaView& deltas, std::span<const Vec3> targets);
  template <class S>
  void sweep_finest(const DeltaView& deltas, std::span<const float> relaxation, const S& s_at);
  void sweep_finest(const DeltaView& deltas, std::span<const float> relaxation);
  void cycle(const DeltaView& deltas, std::span<const Vec3> targets, std::span<const float> relaxation,
             bool is_first);
  void correct_from_second(std::span<const float> relaxation);
  void correct_middle(std::span<const float> relaxation);
  /// `each(take)` calls take(vertex, residual) for every vertex.
  template <class Each>
  void restrict_to_second(const Each& each);
  void solve_coupled();

  bool has_middle() const noexcept { return coupled_ == 2; }

  std::span<const Level> levels_;
  std::size_t coupled_;  ///< c
  LevelSolver solver_;
  Units units_{DeltaView{}, 0};
  LargeVector<Counts> x_;         ///< finest level; none between solutions
  LargeVector<Float4> step_;      ///< finest level: what the last sweep added, and a 0; or second level
  LargeVector<Float4> b_;         ///< second level: right-hand side; empty where c is that
  LargeVector<Float4> u_;         ///< second level: correction of x
  LargeVector<Float4> s_second_;  ///< second level: s
  LargeVector<Float4> s_;         ///< level c: s
  std::vector<Float4> forces_;    ///< one for each anchor
  std::vector<Float4> gaps_;      ///< c_a - x_a before the second level's correction
};

}  // namespace deltamesh::multigrid
