// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The coarse levels of a hierarchy: the mixed equations of one of them, solved by cycles through those below.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/large_vector.h"
#include "laplacian/settling/coarsest.h"
#include "laplacian/settling/level.h"
#include "laplacian/settling/row.h"
#include "laplacian/settling/two_steps.h"

namespace deltamesh::settling {

/// Memory is allocated at setup, but for what another level needs when it first is the coarsest.
class LevelSolver {
 public:
  /// Right-hand sides and solution of a level.
  struct Vectors {
    LargeVector<Row> b;
    LargeVector<Row> u;
    std::vector<Float4> gaps;
    std::vector<Float4> forces;
  };

  /// For `first` and the levels below it. `levels` must outlive this; `holds`: of shared_components;
  /// `is_last_resort`: no coarsening was asked for.
  LevelSolver(std::span<const Level> levels, std::size_t first, std::vector<std::uint8_t> holds,
              std::uint32_t component_count, bool is_last_resort);
  LevelSolver(const LevelSolver&) = delete;
  LevelSolver& operator=(const LevelSolver&) = delete;

  Vectors& vectors(std::size_t level) noexcept { return vectors_[level]; }

  /// The last level is the coarsest again, and no iterations have been made.
  void begin() noexcept;

  /// u and forces of `level` for its b and gaps, from zero: one or two cycles, on the coarsest level a
  /// solution.
  void solve(std::size_t level);

  /// Second half of a cycle on `level`, whose residual is in the next level's b: the correction from there,
  /// and a sweep.
  void correct_from_next(std::size_t level);

  /// Level that is solved, not coarsened.
  std::size_t bottom() const noexcept { return bottom_; }

  /// Makes the second coarsest level the coarsest until begin() is called. False where only one level would
  /// be left.
  bool drop_coarsest();

  /// Whether so many iterations went into coarsest levels since begin() that only few are made from now on.
  bool is_exhausted() const noexcept { return iterations_left_ == 0; }

 private:
  LevelProblem problem(std::size_t level) noexcept;
  void correct(std::size_t level);
  CoarsestEffort effort() const noexcept;
  void make_coarsest();
  void solve_coarsest();

  std::span<const Level> levels_;
  std::vector<std::uint8_t> holds_;  ///< per anchor: 0 where it is alone in its component
  std::uint32_t component_count_;
  bool is_last_resort_;
  std::vector<int> cycles_;  ///< per level, each time it is come to
  std::vector<Vectors> vectors_;
  std::vector<std::unique_ptr<TwoSteps>> two_steps_;  ///< per level; null where there is but one cycle
  std::size_t bottom_;
  std::uint64_t iterations_left_ = 0;                      ///< of conjugate gradients, times nodes
  std::vector<std::unique_ptr<CoarsestSolver>> coarsest_;  ///< per level; null where not needed so far
};

}  // namespace deltamesh::settling
