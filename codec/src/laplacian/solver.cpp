// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/solver.h"

#include <limits>
#include <utility>

#include "base/try.h"
#include "laplacian/anchors/anchors.h"
#include "laplacian/multigrid/setup/levels.h"
#include "laplacian/settling/settle.h"

namespace deltamesh {
LeastSquaresSolver::LeastSquaresSolver(const Adjacency& graph, Components components,
                                       std::span<const std::uint32_t> anchors, ThreadTeam* team)
    : graph_(graph),
      components_(std::move(components)),
      anchors_(anchors.begin(), anchors.end()),
      team_(team) {}

void LeastSquaresSolver::set_up(int cycles) {
  if (cycles == 0 || planned_) return;
  levels_ = multigrid::build_levels(graph_, anchors_, team_);
  if (levels_.size() > 1) planned_.emplace(levels_, shared_anchors(components_, anchors_), team_);
}

Result<void> LeastSquaresSolver::solve(const DeltaView& deltas, std::span<const Vec3> anchor_positions,
                                       int cycles, std::span<Vec3> x) {
  const auto broken = [](const char* message) {
    return Error{.code = ErrorCode::kInvalidStream, .message = message, .rule = "DELT-7"};
  };
  if (cycles == 0) {
    const double step = deltas.has_symbols() ? deltas.scale().step : std::numeric_limits<double>::infinity();
    return settling::settle({graph_, components_, anchors_, deltas, anchor_positions, step}, team_, x);
  }
  set_up(cycles);
  if (!planned_) return broken("planned cycles on a mesh with one level");
  multigrid::RangeWatch watch;
  planned_->solve(deltas, anchor_positions, cycles, &watch).write(x, team_);
  if (!watch.holds()) return broken("planned cycles leave the range of 32 bits");
  return {};
}

Result<LargeVector<Vec3>> LeastSquaresSolver::solve_last(const DeltaView& deltas,
                                                         std::span<const Vec3> anchor_positions, int cycles,
                                                         std::size_t size) {
  set_up(cycles);
  LargeVector<Vec3> x;
  if (cycles == 0 || !planned_) {
    x.resize(size);
    DELTAMESH_CHECK(solve(deltas, anchor_positions, cycles, std::span(x).first(deltas.size())));
    return x;
  }
  const multigrid::PlannedSolution solution = planned_->solve(deltas, anchor_positions, cycles, nullptr);
  planned_.reset();
  levels_.clear();
  x.resize(size);
  solution.write(std::span(x).first(deltas.size()), team_);
  return x;
}

}  // namespace deltamesh
