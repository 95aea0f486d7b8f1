// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/part_solver.h"

#include <algorithm>

#include "base/try.h"

namespace deltamesh {

Result<void> PartSolver::make_solver(std::span<const std::uint32_t> anchors) {
  if (solver_ && std::equal(anchors.begin(), anchors.end(), anchors_.begin(), anchors_.end())) return {};
  solver_.reset();
  anchors_.assign(anchors.begin(), anchors.end());
  DELTAMESH_TRY(solver_, make_solver_for_components(part_.graph, part_.components, anchors_));
  return {};
}

Result<void> PartSolver::solve(std::span<const std::uint32_t> anchors, const DeltaView& deltas,
                               std::span<const Vec3> anchor_positions, int cycles, std::span<Vec3> x) {
  DELTAMESH_CHECK(make_solver(anchors));
  return solver_->solve(deltas, anchor_positions, cycles, x);
}

}  // namespace deltamesh
