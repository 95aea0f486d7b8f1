// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Nested iteration and V-cycles over a hierarchy, in floats.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "laplacian/multigrid_coarsest.h"
#include "laplacian/multigrid_level.h"
#include "laplacian/multigrid_two_steps.h"
#include "topology/adjacency.h"

namespace deltamesh::multigrid {

/// Solves the mixed form of the least-squares problem
///   K x + D^2 s = D delta,   K s = E f,   x_a - f_a = c_a
/// where s = D^-1 (delta - L x) is the residual field and f_a the force with which anchor a pulls. Two
/// second-order problems, coupled vertex by vertex, in place of one of fourth order. Memory is allocated at
/// setup only.
class MultigridCycle {
 public:
  /// The graph's components have about the same number of vertices per anchor; `depth` fits them. Cost O(n +
  /// edges).
  MultigridCycle(const Adjacency& graph, const Components& components, std::span<const std::uint32_t> anchors,
                 std::uint32_t depth);
  MultigridCycle(const MultigridCycle&) = delete;
  MultigridCycle& operator=(const MultigridCycle&) = delete;

  /// Right-hand sides, to be filled in by the caller: b_x = D delta per vertex (the s part is the forces'),
  /// c_a.
  Float4& delta(std::uint32_t vertex) noexcept { return vectors_.front().b[vertex].x; }
  Float4& target(std::size_t anchor) noexcept { return targets_[anchor]; }

  /// The solution so far: x and s per vertex, f per anchor.
  std::span<Row> solution() noexcept { return vectors_.front().u; }
  Float4& force(std::size_t anchor) noexcept { return vectors_.front().b[levels_.front().anchors[anchor]].s; }

  /// A first solution from the second level, whatever was there before.
  void start();

  /// One cycle: more than nine tenths of the error go.
  void cycle();

  /// Makes the second coarsest level the coarsest until start() is called: dearer cycles that converge
  /// faster. The solution stays. False where only one level would be left.
  bool drop_coarsest();

  /// Whether so many iterations went into coarsest levels since start() that only few are made from now on.
  bool is_exhausted() const noexcept { return iterations_left_ == 0; }

 private:
  struct Vectors {
    std::vector<Row> b;
    std::vector<Row> u;
    std::vector<Float4> gaps;
    std::vector<Float4> forces;
  };

  LevelProblem problem(std::size_t level) noexcept;
  /// u and forces of `level` for its b and gaps, from zero: one or two cycles, on the coarsest level a
  /// solution.
  void solve(std::size_t level);
  /// Smooths, on coarse levels from zero, corrects from the next level, smooths.
  void correct(std::size_t level);
  CoarsestEffort effort() const noexcept;
  void solve_coarsest();

  std::vector<std::uint8_t> holds_;  ///< per anchor: 0 where it is alone in its component
  bool is_last_resort_;              ///< no coarsening was asked for
  std::uint32_t component_count_;
  std::vector<Level> levels_;
  std::vector<int> cycles_;  ///< per level
  std::vector<Vectors> vectors_;
  std::vector<Float4> targets_;
  std::vector<std::unique_ptr<TwoSteps>> two_steps_;       ///< per level; null where there is but one cycle
  std::size_t bottom_;                                     ///< level that is solved, not coarsened
  std::uint64_t iterations_left_ = 0;                      ///< of conjugate gradients, times nodes
  std::vector<std::unique_ptr<CoarsestSolver>> coarsest_;  ///< per level; null where not needed so far
};

}  // namespace deltamesh::multigrid
