// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Measures of what planned cycles leave out and of what rounding adds, by which their number is chosen
// [DELT-7].
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/numbers/vec3.h"
#include "topology/adjacency.h"

namespace deltamesh {

/// Errors of positions: how far they are from the true ones, rms and at most, and rms of the delta
/// coordinates' errors, which is what the eye sees. Model units.
struct PlanErrors {
  double rms = 0;
  double largest = 0;
  double roughness = 0;

  /// Whether these are hardly larger than `best`, or so small that nobody would see them.
  bool are_fair(const PlanErrors& best, double invisible) const noexcept;
};

/// `errors`: of the positions of all nodes of `graph`, at least one. O(n + edges).
PlanErrors errors_of(const Adjacency& graph, std::span<const Vec3> errors);

/// What cycles leave out of positions, at most, and by how much it changes deltas that are flat, rms over
/// all. Model units.
struct LeftOut {
  double largest = 0;
  double lost = 0;
};

/// Where deltas are coded as 0, axis by axis, and those around them too: there nothing dithers, and what
/// changes deltas by less than half a step is lost.
class FlatDeltas {
 public:
  /// `symbols`: those of x of all nodes, then of y and z. `graph` must outlive this. O(n + edges).
  FlatDeltas(const Adjacency& graph, std::span<const std::int32_t> symbols);

  /// `errors`: n, that cycles leave. O(n + edges).
  LeftOut left_out(std::span<const Vec3> errors) const;

 private:
  const Adjacency* graph_;
  std::vector<std::array<bool, 3>> flat_;  ///< n: by axis
};

}  // namespace deltamesh
