// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/solver.h"

#include <algorithm>

#include "base/try.h"
#include "laplacian/anchors/anchors.h"
#include "laplacian/multigrid/setup/levels.h"
#include "laplacian/settling/settle.h"

namespace deltamesh {
namespace {

Error broken_plan(const char* message) noexcept {
  return {.code = ErrorCode::kInvalidStream, .message = message, .rule = "DELT-7"};
}

}  // namespace

PlannedSetup::PlannedSetup(const SolverGraph& graph, std::span<const std::uint32_t> anchors)
    : levels_(multigrid::build_levels(graph.graph, anchors, graph.team)) {
  if (levels_.size() > 1) cycles_.emplace(levels_, shared_anchors(graph.components, anchors), graph.team);
}

bool PlannedSetup::is_for(std::span<const std::uint32_t> anchors) const noexcept {
  const auto& own = levels_.front().anchors;
  return std::equal(anchors.begin(), anchors.end(), own.begin(), own.end());
}

Result<multigrid::PlannedSolution> PlannedSetup::solve(const DeltaView& deltas, std::span<const Vec3> targets,
                                                       int cycles, multigrid::RangeWatch* watch) {
  if (!cycles_) return broken_plan("planned cycles on a mesh with one level");
  return cycles_->solve(deltas, targets, cycles, watch);
}

Result<void> LeastSquaresSolver::solve(std::span<const std::uint32_t> anchors, const DeltaView& deltas,
                                       std::span<const Vec3> targets, int cycles, std::span<Vec3> x) {
  if (cycles == 0)
    return settling::settle({graph_.graph, graph_.components, anchors, deltas, targets}, graph_.team, x);
  if (!planned_ || !planned_->is_for(anchors)) {
    planned_.reset();  // before memory is taken for the next one
    planned_.emplace(graph_, anchors);
  }
  multigrid::RangeWatch watch;
  DELTAMESH_TRY(const auto solution, planned_->solve(deltas, targets, cycles, &watch));
  solution.write(x, graph_.team);
  if (!watch.holds()) return broken_plan("planned cycles leave the range of 32 bits");
  return {};
}

SingleSolve::SingleSolve(const SolverGraph& graph, std::span<const std::uint32_t> anchors, int cycles)
    : graph_(graph), anchors_(anchors), cycles_(cycles) {
  if (cycles > 0) planned_.emplace(graph, anchors);
}

Result<LargeVector<Vec3>> SingleSolve::solve(const DeltaView& deltas, std::span<const Vec3> targets,
                                             std::size_t size) && {
  const std::size_t n = graph_.graph.vertex_count();
  LargeVector<Vec3> x;
  if (!planned_) {
    x.resize(size);
    DELTAMESH_CHECK(settling::settle({graph_.graph, graph_.components, anchors_, deltas, targets},
                                     graph_.team, std::span(x).first(n)));
    return x;
  }
  DELTAMESH_TRY(const auto solution, planned_->solve(deltas, targets, cycles_, nullptr));
  planned_.reset();
  x.resize(size);
  solution.write(std::span(x).first(n), graph_.team);
  return x;
}

}  // namespace deltamesh
