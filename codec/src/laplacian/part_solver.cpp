// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/part_solver.h"

#include <algorithm>

namespace deltamesh {

Result<void> PartSolver::solve(std::span<const std::uint32_t> anchors, const DeltaView& deltas,
                               std::span<const Vec3> anchor_positions, int cycles, std::span<Vec3> x) {
  if (!solver_ || !std::equal(anchors.begin(), anchors.end(), anchors_.begin(), anchors_.end())) {
    anchors_.assign(anchors.begin(), anchors.end());
    solver_.emplace(part_.graph, part_.components, anchors_);
  }
  return solver_->solve(deltas, anchor_positions, cycles, x);
}

}  // namespace deltamesh
