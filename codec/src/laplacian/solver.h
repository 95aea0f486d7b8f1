// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The highpass decoder's least-squares problem
//   x = argmin ||L x - delta||^2 + w^2 sum_a ||x_a - c_a||^2,   L = I - D^-1 A,   w = 1,
// with one right-hand side per axis, solved by settling [DELT-4] or by planned cycles [DELT-7].
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/memory/large_vector.h"
#include "base/numbers/vec3.h"
#include "deltamesh/result.h"
#include "laplacian/multigrid/cycle/planned_cycles.h"
#include "laplacian/multigrid/level/level.h"
#include "laplacian/operator/delta_view.h"
#include "topology/adjacency.h"

namespace deltamesh {

class ThreadTeam;

/// The graph and its components, both of n vertices, all of which have neighbours, and the threads that share
/// the work (null: the calling thread works alone). A solver refers to all three, so they must outlive it.
struct SolverGraph {
  const Adjacency& graph;
  const Components& components;
  ThreadTeam* team = nullptr;
};

/// The set-up of planned cycles for one graph and one set of anchors. Memory O(n).
class PlannedSetup {
 public:
  /// `anchors`: distinct vertices, ascending, at least one in every component. O(n).
  PlannedSetup(const SolverGraph& graph, std::span<const std::uint32_t> anchors);

  bool is_for(std::span<const std::uint32_t> anchors) const noexcept;

  /// As PlannedCycles::solve(). Errors: kInvalidStream if the graph has one level only [DELT-7].
  Result<multigrid::PlannedSolution> solve(const DeltaView& deltas, std::span<const Vec3> targets, int cycles,
                                           multigrid::RangeWatch* watch);

 private:
  std::vector<multigrid::Level> levels_;            ///< at least one
  std::optional<multigrid::PlannedCycles> cycles_;  ///< empty if there is one level only
};

/// For encoders: solves for any number of right-hand sides. A planned set-up is kept for the next call with
/// the same anchors.
class LeastSquaresSolver {
 public:
  LeastSquaresSolver(const Adjacency& graph, const Components& components, ThreadTeam* team = nullptr)
      : graph_{graph, components, team} {}
  LeastSquaresSolver(const LeastSquaresSolver&) = delete;
  LeastSquaresSolver& operator=(const LeastSquaresSolver&) = delete;

  /// `anchors`: as PlannedSetup; `deltas`: n; `targets`: one for each anchor; `cycles`: number of planned
  /// cycles, or 0 to settle; `x`: n, overwritten. Errors: kInvalidStream if no solution is found; with
  /// planned cycles if the graph has one level only, or if values leave the range of 32 bits [DELT-7]. Time
  /// and memory O(n).
  Result<void> solve(std::span<const std::uint32_t> anchors, const DeltaView& deltas,
                     std::span<const Vec3> targets, int cycles, std::span<Vec3> x);

 private:
  SolverGraph graph_;
  std::optional<PlannedSetup> planned_;
};

/// For decoders: one problem, set up before its deltas are known and solved once.
class SingleSolve {
 public:
  /// `anchors`, `cycles`: as LeastSquaresSolver::solve(); the anchors must outlive this. Planned cycles are
  /// set up here; settling needs no set-up.
  SingleSolve(const SolverGraph& graph, std::span<const std::uint32_t> anchors, int cycles);

  /// Returns `size` rows, at least n; those from n on are not initialised. The bits are those of
  /// LeastSquaresSolver::solve(), but the range of planned cycles is not checked. The set-up is freed before
  /// the result is allocated. Errors: kInvalidStream if no solution is found, or the graph has one level only
  /// [DELT-7].
  Result<LargeVector<Vec3>> solve(const DeltaView& deltas, std::span<const Vec3> targets,
                                  std::size_t size) &&;

 private:
  SolverGraph graph_;
  std::span<const std::uint32_t> anchors_;
  int cycles_;
  std::optional<PlannedSetup> planned_;
};

}  // namespace deltamesh
