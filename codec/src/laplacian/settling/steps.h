// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Steps towards the least-squares solution, each taken at its best length.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "laplacian/operator/delta_view.h"
#include "topology/adjacency.h"

namespace deltamesh {

/// Generalised conjugate residuals: a proposed step is made orthogonal, in the norm of ||L x||^2 + sum_a
/// ||x_a||^2, to the last steps, and taken at the length that minimises the functional. Every component and
/// axis on its own. The functional never rises, whatever is proposed. Memory: 170 bytes per vertex.
class Steps {
 public:
  /// From x = 0. Spans must outlive this; every vertex has neighbours.
  Steps(const Adjacency& graph, const Components& components, std::span<const std::uint32_t> anchors,
        const DeltaView& deltas, std::span<const Vec3> targets);

  std::span<const Vec3> residual() const noexcept { return residual_; }  ///< n: delta - L x
  std::span<const Vec3> gaps() const noexcept { return gaps_; }          ///< one per anchor: c_a - x_a

  /// n, to be filled in before take().
  std::span<Vec3> proposed() noexcept { return directions_[count_ % directions_.size()].step; }

  /// Proposes the gradient over the diagonal of the normal equations: steps of conjugate gradients.
  void propose_gradient();

  /// Adds to `x` what is taken of the proposed step. O(n + edges).
  void take(std::span<Vec3> x);

 private:
  struct Direction {
    std::vector<Vec3> step;
    std::vector<Vec3> image;   ///< L step
    std::vector<Vec3> energy;  ///< per component: ||L step||^2 + sum_a ||step_a||^2
  };

  template <class Vertex, class Anchor>
  std::vector<Vec3> sum_up(const Vertex& vertex, const Anchor& anchor) const;
  void make_orthogonal(Direction& direction, const Direction& other) const;

  const Adjacency& graph_;
  const Components& components_;
  std::span<const std::uint32_t> anchors_;
  std::array<Direction, 2> directions_;  ///< the next at count_ % 2
  std::size_t count_ = 0;
  std::vector<Vec3> residual_;
  std::vector<Vec3> gaps_;
};

}  // namespace deltamesh
