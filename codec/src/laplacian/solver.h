// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The highpass decoder's least-squares problem
//   x = argmin ||L x - delta||^2 + w^2 sum_a ||x_a - c_a||^2,   L = I - D^-1 A,   w = 1,
// one right-hand side per axis: settled [DELT-4], or what planned cycles make of it [DELT-7], on the same
// levels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/large_vector.h"
#include "base/vec3.h"
#include "deltamesh/result.h"
#include "laplacian/multigrid/cycle/planned_cycles.h"
#include "laplacian/multigrid/level/level.h"
#include "laplacian/operator/delta_view.h"
#include "topology/adjacency.h"

namespace deltamesh {

class ThreadTeam;

/// Set up once for a graph and its anchors, then solved for any right-hand sides. Time and memory are linear
/// in n. What is left of the error where it settles is a few percent of what quantisation leaves.
class LeastSquaresSolver {
 public:
  /// `components`: of `graph`, which must outlive the solver; every vertex has neighbours; `anchors`:
  /// distinct vertices, ascending, at least one in every component. Work is shared by the threads of `team`,
  /// which must outlive the solver; null: the caller's does it alone.
  LeastSquaresSolver(const Adjacency& graph, Components components, std::span<const std::uint32_t> anchors,
                     ThreadTeam* team = nullptr);
  LeastSquaresSolver(const LeastSquaresSolver&) = delete;
  LeastSquaresSolver& operator=(const LeastSquaresSolver&) = delete;

  /// What solve() for so many cycles would set up first.
  void set_up(int cycles);

  /// `deltas`: n; `anchor_positions`: one per anchor, in the order of setup; `cycles`: planned ones, or 0
  /// for as many steps as the solution takes; `x`: n, overwritten. Errors: kInvalidStream where the system is
  /// numerically singular or its solution out of reach; for planned cycles where the graph has one level, or
  /// where they leave the range of 32 bits [DELT-7].
  Result<void> solve(const DeltaView& deltas, std::span<const Vec3> anchor_positions, int cycles,
                     std::span<Vec3> x);

  /// The same for decoders, which do not ask about that range: n rows, in memory of `size` rows, n or more,
  /// the others not initialised. With planned cycles that memory is taken after what was set up has been
  /// given back: the solver is of no use any more.
  Result<LargeVector<Vec3>> solve_last(const DeltaView& deltas, std::span<const Vec3> anchor_positions,
                                       int cycles, std::size_t size);

 private:
  const Adjacency& graph_;
  Components components_;
  std::vector<std::uint32_t> anchors_;
  ThreadTeam* team_;
  std::vector<multigrid::Level> levels_;
  std::optional<multigrid::PlannedCycles> planned_;
};

}  // namespace deltamesh
