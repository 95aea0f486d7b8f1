// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Nested iteration and V-cycles over a hierarchy, in floats.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "laplacian/settling/level.h"
#include "laplacian/settling/level_solver.h"
#include "topology/adjacency.h"

namespace deltamesh::settling {

/// Solves the mixed form of the least-squares problem
///   K x + D^2 s = D delta,   K s = E f,   x_a - f_a = c_a
/// where s = D^-1 (delta - L x) is the residual field and f_a the force with which anchor a pulls. Two
/// second-order problems, coupled vertex by vertex, in place of one of fourth order. Memory is allocated at
/// setup only.
class CoupledCycle {
 public:
  /// `levels`, which must outlive this: those of a graph whose components have about the same number of
  /// vertices per anchor; `is_last_resort`: there is but one, as asked.
  CoupledCycle(std::span<const Level> levels, const Components& components, bool is_last_resort);
  CoupledCycle(const CoupledCycle&) = delete;
  CoupledCycle& operator=(const CoupledCycle&) = delete;

  /// Right-hand sides, to be filled in by the caller: b_x = D delta per vertex (the s part is the forces'),
  /// c_a.
  Float4& delta(std::uint32_t vertex) noexcept { return solver_.vectors(0).b[vertex].x; }
  Float4& target(std::size_t anchor) noexcept { return targets_[anchor]; }

  /// The solution so far: x and s per vertex, f per anchor.
  std::span<Row> solution() noexcept { return solver_.vectors(0).u; }
  Float4& force(std::size_t anchor) noexcept { return solver_.vectors(0).b[finest_.anchors[anchor]].s; }

  /// A first solution from the second level, whatever was there before.
  void start();

  /// One cycle: more than nine tenths of the error go.
  void cycle();

  /// Makes the second coarsest level the coarsest until start() is called: dearer cycles that converge
  /// faster. The solution stays. False where only one level would be left.
  bool drop_coarsest() { return solver_.drop_coarsest(); }

  /// Whether so many iterations went into coarsest levels since start() that only few are made from now on.
  bool is_exhausted() const noexcept { return solver_.is_exhausted(); }

 private:
  const Level& finest_;
  LevelSolver solver_;
  std::vector<Float4> targets_;
};

}  // namespace deltamesh::settling
