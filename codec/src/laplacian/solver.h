// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The highpass decoder's problem: positions x of which planned cycles [DELT-7] make
//   ||L x - delta||^2 + sum_a ||x_a - c_a||^2,   L = I - D^-1 A,
// small, for each axis by itself; of components of few vertices, the smallest possible.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "base/memory/large_vector.h"
#include "base/numbers/vec3.h"
#include "deltamesh/result.h"
#include "laplacian/component_problem.h"
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

/// The set-up for one graph and one set of anchors. Memory O(n).
class PlannedSetup {
 public:
  /// `anchors`: distinct vertices, ascending, at least one in every component. O(n).
  PlannedSetup(const SolverGraph& graph, std::span<const std::uint32_t> anchors);

  bool is_for(std::span<const std::uint32_t> anchors) const noexcept;

  /// What the cycles find in one component.
  struct Part {
    const ComponentProblem* problem;
    multigrid::PlannedSolution solution;
  };
  /// Of components of many vertices. `deltas`: n; `targets`: one for each anchor; `cycles`, `watch`: as
  /// PlannedCycles::solve(). Errors: kLimitExceeded where a component has too many vertices. O(n cycles).
  Result<std::vector<Part>> run_cycles(const DeltaView& deltas, std::span<const Vec3> targets, int cycles,
                                       multigrid::RangeWatch* watch);

  /// Frees what run_cycles() needs.
  void drop_levels() noexcept { cycled_.clear(); }

  /// Calls look() with what run_cycles() finds by 1, 2, 3... cycles, until it returns false. Errors:
  /// likewise.
  Result<void> follow_cycles(const DeltaView& deltas, std::span<const Vec3> targets,
                             multigrid::RangeWatch* watch,
                             const std::function<bool(std::span<const Part>)>& look);

  /// `x`: n, of which the components of `parts` are overwritten. O(n).
  void write(std::span<const Part> parts, std::span<Vec3> x) const;
  /// The others, of few vertices. O(n).
  void solve_small(const DeltaView& deltas, std::span<const Vec3> targets, std::span<Vec3> x) const;

 private:
  struct Cycled {
    const ComponentProblem* problem;
    Adjacency graph;                                   ///< empty where the whole graph is one component
    std::vector<multigrid::Level> levels{};            ///< at least one
    std::optional<multigrid::PlannedCycles> cycles{};  ///< empty if there is one level only
  };

  /// Errors: kLimitExceeded where a component has too many vertices.
  Result<void> check_size() const;

  SolverGraph graph_;
  std::vector<std::uint32_t> anchors_;
  std::vector<ComponentProblem> problems_;
  std::deque<Cycled> cycled_;
};

/// For encoders: solves for any number of right-hand sides. The set-up is kept for the next call with the
/// same anchors.
class PlannedSolver {
 public:
  PlannedSolver(const Adjacency& graph, const Components& components) : graph_{graph, components} {}
  PlannedSolver(const PlannedSolver&) = delete;
  PlannedSolver& operator=(const PlannedSolver&) = delete;

  /// `anchors`, `deltas`, `targets`: as PlannedSetup; `cycles`: above 0; `x`: n, overwritten. Errors:
  /// kInvalidStream where values leave the range of 32 bits [DELT-7]. Time and memory O(n).
  Result<void> solve(std::span<const std::uint32_t> anchors, const DeltaView& deltas,
                     std::span<const Vec3> targets, int cycles, std::span<Vec3> x);

  /// Calls look(cycles, x) with what solve() finds by 1, 2, 3... cycles, until it returns false. Costs about
  /// twice the last of them. Errors: as solve().
  using Look = std::function<bool(int cycles, std::span<const Vec3> x)>;
  Result<void> follow(std::span<const std::uint32_t> anchors, const DeltaView& deltas,
                      std::span<const Vec3> targets, const Look& look);

 private:
  PlannedSetup& setup_for(std::span<const std::uint32_t> anchors);

  SolverGraph graph_;
  std::optional<PlannedSetup> planned_;
};

/// For decoders: one problem, set up before its deltas are known and solved once.
class SingleSolve {
 public:
  /// `anchors`: as PlannedSetup.
  SingleSolve(const SolverGraph& graph, std::span<const std::uint32_t> anchors) : setup_(graph, anchors) {}

  /// Returns `size` rows, at least n; those from n on are not initialised. The bits are those of
  /// PlannedSolver::solve(), but the range is not checked. The set-up is freed before the result is
  /// allocated. Errors: as PlannedSetup::run_cycles().
  Result<LargeVector<Vec3>> solve(const DeltaView& deltas, std::span<const Vec3> targets, int cycles,
                                  std::size_t size) &&;

 private:
  PlannedSetup setup_;
};

}  // namespace deltamesh
