// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The highpass decoder's least-squares problem
//   x = argmin ||L x - delta||^2 + w^2 sum_a ||x_a - c_a||^2,   L = I - D^-1 A,   w = 1,
// one right-hand side per axis: settled [DELT-4], or what planned cycles make of it [DELT-7].
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

/// Time and memory are linear in n. What is set up for anchors and planned cycles is kept until other anchors
/// come.
class LeastSquaresSolver {
 public:
  /// `graph`: n vertices, which have neighbours; `components`: its own. Both must outlive the solver. Work is
  /// shared by the threads of `team`, which must outlive it too; null: the caller's does it alone.
  LeastSquaresSolver(const Adjacency& graph, const Components& components, ThreadTeam* team = nullptr)
      : graph_(graph), components_(components), team_(team) {}
  LeastSquaresSolver(const LeastSquaresSolver&) = delete;
  LeastSquaresSolver& operator=(const LeastSquaresSolver&) = delete;

  /// What solve() would set up first: for planned cycles their levels, for 0 nothing.
  void set_up(std::span<const std::uint32_t> anchors, int cycles);

  /// `anchors`: distinct vertices, ascending, at least one in every component; `deltas`: n; `targets`: one
  /// for each anchor; `cycles`: planned ones, or 0 for the least-squares solution, near enough; `x`: n,
  /// overwritten. Errors: kInvalidStream where the solution is out of reach; for planned cycles where the
  /// graph has one level, or where they leave the range of 32 bits [DELT-7].
  Result<void> solve(std::span<const std::uint32_t> anchors, const DeltaView& deltas,
                     std::span<const Vec3> targets, int cycles, std::span<Vec3> x);

  /// The same for decoders, which do not ask about that range: n rows, in memory of `size` rows, n or more,
  /// the others not initialised. With planned cycles that memory is taken after what was set up has been
  /// given back: the solver is of no use any more.
  Result<LargeVector<Vec3>> solve_last(std::span<const std::uint32_t> anchors, const DeltaView& deltas,
                                       std::span<const Vec3> targets, int cycles, std::size_t size);

 private:
  const Adjacency& graph_;
  const Components& components_;
  ThreadTeam* team_;
  std::vector<std::uint32_t> anchors_;    ///< that the levels are for
  std::vector<multigrid::Level> levels_;  ///< none before they are asked for
  std::optional<multigrid::PlannedCycles> planned_;
};

}  // namespace deltamesh
