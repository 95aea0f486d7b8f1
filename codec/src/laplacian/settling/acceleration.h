// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Steers V-cycles by the least-squares functional, where they alone do not settle.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "laplacian/settling/cycle.h"
#include "laplacian/settling/groups.h"

namespace deltamesh::settling {

/// Size of a step, of one component.
struct Change {
  double squares = 0;  ///< sum of |step|^2
  double largest = 0;  ///< largest |step|^2
};

/// Generalised conjugate residuals with V-cycles as preconditioner: a cycle's step is made orthogonal, in the
/// norm of
/// ||L x||^2 + sum_a ||x_a||^2, to the last kDirections steps, and taken at the length that minimises the
/// functional. Every component and axis on its own. The functional never rises, whatever the cycle does.
/// Memory: kDirections x 48 bytes per vertex.
class Acceleration {
 public:
  /// `group` must outlive this.
  explicit Acceleration(const Group& group);

  /// To be called whenever `cycles` got new right-hand sides and a solution of zero.
  void restart(CoupledCycle& cycles);

  /// One accelerated cycle. O(n + edges + kDirections n).
  void cycle(CoupledCycle& cycles);

  /// Per component, the step that the last cycle proposed. Unlike the step taken it is small near the
  /// solution only, not where progress has stalled.
  std::span<const Change> proposed() const noexcept { return proposed_; }

 private:
  static constexpr std::size_t kDirections = 2;
  using Sums = std::array<double, 3>;

  struct Direction {
    std::vector<Row> step;       ///< of x and s
    std::vector<Float4> image;   ///< L step
    std::vector<Float4> forces;  ///< step of the forces
    std::vector<Sums> energy;    ///< per component: ||L step||^2 + sum_a ||step_a||^2
    std::vector<Sums> overlap;   ///< per component: scratch
    std::vector<Float4> share;   ///< per component: scratch
  };

  void take_step(CoupledCycle& cycles, Direction& direction);
  void apply_laplacian(Direction& direction) const;
  void orthogonalize(Direction& direction);
  void move(CoupledCycle& cycles, Direction& direction);

  const Group& group_;
  std::vector<Direction> directions_;  ///< the newest at (count_ - 1) % kDirections
  std::size_t count_ = 0;
  std::vector<Change> proposed_;
  std::vector<Row> before_;
  std::vector<Float4> forces_before_;
  std::vector<Float4> residual_;         ///< delta - L x
  std::vector<Float4> anchor_residual_;  ///< c - x_a
};

}  // namespace deltamesh::settling
