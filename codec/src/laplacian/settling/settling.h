// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Whether steps towards a least-squares solution have settled: what they still change, beside the error that
// quantisation left.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "laplacian/operator/delta_view.h"
#include "laplacian/settling/steps.h"
#include "topology/adjacency.h"

namespace deltamesh {

/// Size of a change of x, of one component.
struct Change {
  double squares = 0;  ///< sum of |change|^2
  double largest = 0;  ///< largest |change|^2
};
/// `change`: of every vertex.
std::vector<Change> measure(const Components& components, std::span<const Vec3> change);

class Settling {
 public:
  /// Spans must outlive this. `deltas`: n; `targets`: of every anchor.
  Settling(const Adjacency& graph, const Components& components, const DeltaView& deltas,
           std::span<const Vec3> targets);

  /// Whether what is still to come is small in every component, after `steps` to `x`, the last of which were
  /// `changes`. `rate`: what they leave of the changes before. O(n).
  bool is_settled(std::span<const Change> changes, double rate, const Steps& steps,
                  std::span<const Vec3> x) const;

  /// Largest rms change of a component.
  double worst(std::span<const Change> changes) const noexcept;

 private:
  double expected_error(const Steps& steps) const noexcept;
  double error_of_forces(const Steps& steps) const noexcept;
  double error_of_lone_anchors(const Steps& steps) const noexcept;

  const Adjacency& graph_;
  const Components& components_;
  std::span<const Vec3> targets_;
  bool has_hub_;
  double delta_rms_;
};

}  // namespace deltamesh
