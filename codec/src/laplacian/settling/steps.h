// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Steps towards the least-squares solution [DELT-4], each taken at its best length.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/memory/large_vector.h"
#include "laplacian/multigrid/cycle/level_solver.h"
#include "laplacian/multigrid/level/row.h"
#include "laplacian/settling/problem.h"
#include "topology/adjacency.h"

namespace deltamesh::settling {

using multigrid::Double4;

/// Figures of one step in one component: sums of squares over its vertices, and for the functional also over
/// its anchors. The fourth axis is the probe.
struct Progress {
  double functional = 0;  ///< that is left, all three axes together
  double decrease = 0;    ///< of the functional, by the step
  Double4 proposed{};     ///< the proposal's x
  Double4 taken{};        ///< what x changed by
  double probe = 0;       ///< the probe's x
};

/// An iterate of the coupled problem K x + D^2 s = D delta, K s = E f, x_a - f_a = c_a, in doubles. A solver
/// proposes a step of x, s and f for the residual. The step is made orthogonal to the last three in the norm
/// of ||L x||^2 + sum_a |x_a|^2, so that an error that all proposals share does not shorten every step
/// [Vinsome, Orthomin, 1976]. It is taken at the length that minimises the functional ||L x - delta||^2 +
/// sum_a |x_a - c_a|^2, for each component and axis separately, so that the functional never rises. A fourth
/// axis, the probe, has random deltas and targets of 0: its solution shows how errors of deltas spread.
/// Memory: 450 bytes per vertex.
class Steps {
 public:
  /// Starts from x = 0. All numbers are divided by `unit`, a power of 2. The objects that `problem` refers to
  /// must outlive this.
  Steps(const Problem& problem, double unit);

  /// Sets b and gaps of `problem` to the residual of the coupled problem. O(n + edges).
  void set_residual(multigrid::LevelSolver::Vectors& problem) const;

  /// Takes a step with u and forces of `problem` as the proposal. O(n + edges).
  void take(const multigrid::LevelSolver::Vectors& problem);

  /// Figures of the last step, per component.
  std::span<const Progress> progress() const noexcept { return progress_; }

  /// The iterate, divided by `unit`.
  std::span<const Double4> x() const noexcept { return x_; }

 private:
  static constexpr std::size_t kDirections = 3;
  using PerDirection = std::array<Double4, kDirections>;

  struct Direction {
    LargeVector<Double4> x;
    LargeVector<Double4> s;
    LargeVector<Double4> image;   ///< D^-1 L x
    std::vector<Double4> forces;  ///< per anchor
    std::vector<Double4> energy;  ///< per component: ||L x||^2 + sum_a |x_a|^2
  };
  /// Sums over one component.
  struct Sums {
    Double4 own;         ///< energy of the proposal
    PerDirection cross;  ///< its products with the last directions
    Double4 gain;        ///< its product with the residual
    Double4 x;           ///< squares of its x
  };

  std::vector<Sums> add_up(const multigrid::LevelSolver::Vectors& problem);
  void take_vertices(const multigrid::LevelSolver::Vectors& problem, std::span<const PerDirection> share,
                     std::span<const Double4> length, Direction& direction);

  const Adjacency& graph_;
  const Components& components_;
  std::span<const std::uint32_t> anchors_;
  LargeVector<Double4> x_;
  LargeVector<Double4> s_;                   ///< of the iterate
  LargeVector<Double4> residual_;            ///< D^-1 (delta - L x), what s comes to at the solution
  std::vector<Double4> forces_;              ///< per anchor: f
  std::vector<Double4> gaps_;                ///< per anchor: c_a - x_a
  std::array<Direction, kDirections> last_;  ///< zeros where there was none
  std::size_t taken_ = 0;                    ///< steps; the next one overwrites the oldest
  LargeVector<Double4> image_;               ///< of the proposal
  std::vector<Progress> progress_;
};

}  // namespace deltamesh::settling
