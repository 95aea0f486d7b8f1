// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/solver.h"

#include <algorithm>

#include "base/try.h"
#include "laplacian/anchors/anchors.h"
#include "laplacian/multigrid/setup/levels.h"
#include "laplacian/settling/settle.h"

namespace deltamesh {

void LeastSquaresSolver::set_up(std::span<const std::uint32_t> anchors, int cycles) {
  if (cycles == 0) return;
  if (!levels_.empty() && std::equal(anchors.begin(), anchors.end(), anchors_.begin(), anchors_.end()))
    return;
  planned_.reset();
  anchors_.assign(anchors.begin(), anchors.end());
  levels_ = multigrid::build_levels(graph_, anchors_, team_);
  if (levels_.size() > 1) planned_.emplace(levels_, shared_anchors(components_, anchors_), team_);
}

Result<void> LeastSquaresSolver::solve(std::span<const std::uint32_t> anchors, const DeltaView& deltas,
                                       std::span<const Vec3> targets, int cycles, std::span<Vec3> x) {
  const auto broken = [](const char* message) {
    return Error{.code = ErrorCode::kInvalidStream, .message = message, .rule = "DELT-7"};
  };
  if (cycles == 0) return settling::settle({graph_, components_, anchors, deltas, targets}, team_, x);
  set_up(anchors, cycles);
  if (!planned_) return broken("planned cycles on a mesh with one level");
  multigrid::RangeWatch watch;
  planned_->solve(deltas, targets, cycles, &watch).write(x, team_);
  if (!watch.holds()) return broken("planned cycles leave the range of 32 bits");
  return {};
}

Result<LargeVector<Vec3>> LeastSquaresSolver::solve_last(std::span<const std::uint32_t> anchors,
                                                         const DeltaView& deltas,
                                                         std::span<const Vec3> targets, int cycles,
                                                         std::size_t size) {
  set_up(anchors, cycles);
  LargeVector<Vec3> x;
  if (cycles == 0 || !planned_) {
    x.resize(size);
    DELTAMESH_CHECK(solve(anchors, deltas, targets, cycles, std::span(x).first(deltas.size())));
    return x;
  }
  const multigrid::PlannedSolution solution = planned_->solve(deltas, targets, cycles, nullptr);
  planned_.reset();
  levels_.clear();
  x.resize(size);
  solution.write(std::span(x).first(deltas.size()), team_);
  return x;
}

}  // namespace deltamesh
