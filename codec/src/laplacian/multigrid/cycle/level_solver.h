// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The coupled problem on a level, solved by cycles through the coarser ones [DELT-7].
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/memory/large_vector.h"
#include "laplacian/coarsest/coarsest.h"
#include "laplacian/multigrid/level/coupled_problem.h"
#include "laplacian/multigrid/level/level.h"
#include "laplacian/multigrid/level/row.h"

namespace deltamesh::multigrid {

/// Memory is allocated at setup only.
class LevelSolver {
 public:
  /// Right-hand sides and solution of a level.
  struct Vectors {
    LargeVector<Row> b;
    LargeVector<Row> u;
    std::vector<Float4> gaps;
    std::vector<Float4> forces;
    LargeVector<Row> first;  ///< what is taken of the first cycle's u; empty where there is one cycle
    LargeVector<Row> image;  ///< what the equations make of it; likewise
    std::vector<Float4> first_forces;  ///< likewise
  };

  /// `levels`: the one to solve for and all that are coarser; must outlive this. `team`: of the thread that
  /// solves, or null.
  LevelSolver(std::span<const Level> levels, ThreadTeam* team);
  LevelSolver(const LevelSolver&) = delete;
  LevelSolver& operator=(const LevelSolver&) = delete;

  /// Vectors of the first level.
  Vectors& first() noexcept { return vectors_.front(); }

  /// Its u and forces for its b and gaps, which are used up.
  void solve() { solve(0); }

 private:
  CoupledProblem problem(std::size_t level) noexcept;
  void solve(std::size_t level);
  void cycle(std::size_t level);

  std::span<const Level> levels_;
  std::vector<Vectors> vectors_;  ///< per level
  CoarsestSolver coarsest_;
  ThreadTeam* team_;
};

}  // namespace deltamesh::multigrid
