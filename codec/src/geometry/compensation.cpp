// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "geometry/compensation.h"

#include "base/try.h"
#include "laplacian/delta.h"

namespace deltamesh {

Compensation::Compensation(const SolvedPart& part, std::span<const Vec3> positions, const Vec3& center)
    : part_(part),
      positions_(positions),
      center_(center),
      shifted_(positions.begin(), positions.end()),
      deltas_(delta_coordinates(part, shifted_)) {}

Result<void> Compensation::improve(PartSolver& solver, std::span<const std::uint32_t> anchors, int cycles) {
  std::vector<Vec3> targets;
  for (const std::uint32_t row : anchors) targets.push_back(shifted_[part_.vertex(row)] - center_);
  std::vector<Vec3> x(part_.row_count);
  DELTAMESH_CHECK(solver.solve(anchors, deltas_, targets, cycles, x));
  for (std::size_t row = 0; row < x.size(); ++row) {
    const std::uint32_t v = part_.vertex(row);
    shifted_[v] = shifted_[v] + (positions_[v] - (center_ + x[row]));
  }
  deltas_ = delta_coordinates(part_, shifted_);
  return {};
}

}  // namespace deltamesh
