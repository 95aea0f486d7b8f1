// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// So many cycles as planned, or steps by cycles until they settle, on the same levels.
#include "laplacian/solver.h"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/try.h"
#include "laplacian/anchors/shared_components.h"
#include "laplacian/multigrid/cycle/planned_cycles.h"
#include "laplacian/multigrid/setup/levels.h"
#include "laplacian/settling/settled_solver.h"

namespace deltamesh {
namespace {

using multigrid::PlannedCycles;
using multigrid::PlannedSolution;

class MultigridSolver final : public LeastSquaresSolver {
 public:
  MultigridSolver(const Adjacency& graph, Components components, std::span<const std::uint32_t> anchors,
                  ThreadTeam* team)
      : graph_(graph),
        components_(std::move(components)),
        anchors_(anchors.begin(), anchors.end()),
        team_(team) {}

  void set_up(int cycles) override {
    if (levels_.empty()) levels_ = multigrid::build_levels(graph_, anchors_, team_);
    if (cycles == 0 && !settled_) {
      multigrid::add_weights(levels_.front());
      settled_.emplace(graph_, components_, anchors_, levels_, team_);
    }
    if (cycles > 0 && !planned_ && levels_.size() > 1)
      planned_.emplace(levels_, shared_components(components_, anchors_), team_);
  }

  Result<void> solve(const DeltaView& deltas, std::span<const Vec3> anchor_positions, int cycles,
                     std::span<Vec3> x) override {
    set_up(cycles);
    if (cycles == 0) return settled_->solve(deltas, anchor_positions, x);
    if (!planned_) return no_levels();
    multigrid::RangeWatch watch;
    planned_->solve(deltas, anchor_positions, cycles, &watch).write(x, team_);
    if (!watch.holds()) return out_of_range();
    return {};
  }

  Result<LargeVector<Vec3>> solve_last(const DeltaView& deltas, std::span<const Vec3> anchor_positions,
                                       int cycles, std::size_t size) override {
    set_up(cycles);
    if (cycles == 0 || !planned_)
      return LeastSquaresSolver::solve_last(deltas, anchor_positions, cycles, size);
    const PlannedSolution solution = planned_->solve(deltas, anchor_positions, cycles, nullptr);
    planned_.reset();
    levels_.clear();
    LargeVector<Vec3> x(size);
    solution.write(std::span(x).first(deltas.size()), team_);
    return x;
  }

 private:
  static Error no_levels() {
    return {.code = ErrorCode::kInvalidStream,
            .message = "planned cycles on a mesh with one level",
            .rule = "DELT-7"};
  }

  static Error out_of_range() {
    return {.code = ErrorCode::kInvalidStream,
            .message = "planned cycles leave the range of 32 bits",
            .rule = "DELT-7"};
  }

  const Adjacency& graph_;
  Components components_;
  std::vector<std::uint32_t> anchors_;
  ThreadTeam* team_;
  std::vector<multigrid::Level> levels_;
  std::optional<PlannedCycles> planned_;
  std::optional<settling::SettledSolver> settled_;
};

}  // namespace

Result<std::unique_ptr<LeastSquaresSolver>> make_multigrid_solver(const Adjacency& graph,
                                                                  std::span<const std::uint32_t> anchors) {
  return make_solver_for_components(graph, find_components(graph), anchors);
}

Result<std::unique_ptr<LeastSquaresSolver>> make_solver_for_components(const Adjacency& graph,
                                                                       Components components,
                                                                       std::span<const std::uint32_t> anchors,
                                                                       ThreadTeam* team) {
  return std::unique_ptr<LeastSquaresSolver>(
      std::make_unique<MultigridSolver>(graph, std::move(components), anchors, team));
}

}  // namespace deltamesh
