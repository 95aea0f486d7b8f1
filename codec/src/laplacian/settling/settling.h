// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Whether the components of a group have settled: what cycles still change, beside the error that
// quantisation left.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "laplacian/operator/delta_view.h"
#include "laplacian/settling/acceleration.h"
#include "laplacian/settling/cycle.h"
#include "laplacian/settling/groups.h"

namespace deltamesh::settling {

/// Vertices of a component that is factored where it does not settle.
inline constexpr std::uint32_t kLargestRescue = 2000;

/// A solution in the making.
struct Progress {
  const DeltaView& deltas;
  std::span<const Vec3> targets;  ///< of every anchor
  std::span<const Vec3> x;
  CoupledCycle& cycles;  ///< which have the forces and the residual field
};

class Settling {
 public:
  /// `group` must outlive this.
  explicit Settling(const Group& group);

  /// A step over all vertices: start_step(), then measure() of each; or all of its components' changes at
  /// once.
  void start_step() { std::fill(changes_.begin(), changes_.end(), Change{}); }
  void measure(std::uint32_t vertex, const Vec3& step) noexcept {
    const double square = dot(step, step);
    Change& change = changes_[group_.components.label[vertex]];
    change.squares += square;
    change.largest = std::max(change.largest, square);
  }
  void take_step(std::span<const Change> changes) {
    std::copy(changes.begin(), changes.end(), changes_.begin());
  }

  /// Largest rms change of a component.
  double worst_change() const noexcept;

  /// Whether what is still to come is small; marks the components where it is not. `rate`: what a cycle
  /// leaves of the change of the one before.
  bool is_settled(double rate, const Progress& progress);

  /// Takes the mark from large components that hardly move.
  void tolerate_large_components(const Progress& progress);

  /// The marks, a flag for each component.
  std::span<const std::uint8_t> unsettled() const noexcept { return unsettled_; }

 private:
  double expected_error(const Progress& progress) const noexcept;
  double error_of_forces(const Progress& progress) const noexcept;
  double error_of_lone_anchors(const Progress& progress) const noexcept;

  const Group& group_;
  bool has_hub_;
  std::vector<Change> changes_;
  std::vector<std::uint8_t> unsettled_;
};

}  // namespace deltamesh::settling
