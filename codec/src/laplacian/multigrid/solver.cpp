// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// So many cycles as planned, or steps by cycles until they settle.
#include "laplacian/solver.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/try.h"
#include "laplacian/multigrid/cycle/planned_cycles.h"
#include "laplacian/multigrid/setup/levels.h"
#include "laplacian/settling/settling.h"
#include "laplacian/settling/steps.h"

namespace deltamesh {
namespace {

using multigrid::PlannedCycles;
using multigrid::PlannedSolution;

/// Of a solution that settles: a round is a cycle and so many steps of conjugate gradients, for the
/// directions in which cycles are wrong: next to anchors, and where components have few anchors or hang by
/// few edges.
constexpr int kGradientSteps = 4;
constexpr int kMostRounds = 1000;

/// Per anchor, whether its component has another.
std::vector<std::uint8_t> shared_components(const Components& components,
                                            std::span<const std::uint32_t> anchors) {
  std::vector<std::uint32_t> count(components.count, 0);
  for (const std::uint32_t anchor : anchors) ++count[components.label[anchor]];
  std::vector<std::uint8_t> shared;
  for (const std::uint32_t anchor : anchors) shared.push_back(count[components.label[anchor]] > 1 ? 1 : 0);
  return shared;
}

/// A power of 2, about the largest coordinate; not finite where that is not.
double unit_for(std::span<const Vec3> a, std::span<const Vec3> b) noexcept {
  double largest = 0;
  double nothing = 0;  // the sum of what is 0 where values are finite, else not a number
  for (const auto& vectors : {a, b}) {
    for (const Vec3& v : vectors) {
      largest = std::max(largest, std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}));
      nothing += 0 * (v[0] + v[1] + v[2]);
    }
  }
  return (largest > 0 && std::isfinite(largest) ? std::ldexp(1.0, std::ilogb(largest)) : 1.0) + nothing;
}

std::vector<Vec3> scaled(double factor, std::span<const Vec3> vectors) {
  std::vector<Vec3> result;
  for (const Vec3& v : vectors) result.push_back(factor * v);
  return result;
}

class MultigridSolver final : public LeastSquaresSolver {
 public:
  MultigridSolver(const Adjacency& graph, Components components, std::span<const std::uint32_t> anchors)
      : graph_(graph), components_(std::move(components)), anchors_(anchors.begin(), anchors.end()) {}

  void set_up() override {
    if (!levels_.empty()) return;
    levels_ = multigrid::build_levels(graph_, anchors_);
    if (levels_.size() > 1) planned_.emplace(levels_, shared_components(components_, anchors_));
  }

  Result<void> solve(const DeltaView& deltas, std::span<const Vec3> anchor_positions, int cycles,
                     std::span<Vec3> x) override {
    set_up();
    if (cycles == 0) return settle(deltas, anchor_positions, x);
    if (!planned_) return no_levels();
    planned_->solve(deltas, anchor_positions, cycles).write(x);
    return {};
  }

  Result<LargeVector<Vec3>> solve_last(const DeltaView& deltas, std::span<const Vec3> anchor_positions,
                                       int cycles, std::size_t size) override {
    set_up();
    if (cycles == 0 || !planned_)
      return LeastSquaresSolver::solve_last(deltas, anchor_positions, cycles, size);
    const PlannedSolution solution = planned_->solve(deltas, anchor_positions, cycles);
    planned_.reset();
    levels_.clear();
    LargeVector<Vec3> x(size);
    solution.write(std::span(x).first(deltas.size()));
    return x;
  }

 private:
  static Error no_levels() {
    return {.code = ErrorCode::kInvalidStream,
            .message = "planned cycles on a mesh with one level",
            .rule = "DELT-7"};
  }

  Result<void> settle(const DeltaView& deltas, std::span<const Vec3> anchor_positions, std::span<Vec3> x) {
    std::vector<Vec3> all_deltas;
    for (std::size_t i = 0; i < deltas.size(); ++i) all_deltas.push_back(deltas[i]);
    const double unit = unit_for(all_deltas, anchor_positions);  // squares of any size would overflow
    if (!std::isfinite(unit)) {  // the caller finds positions that are not finite
      std::fill(x.begin(), x.end(), Vec3{unit, unit, unit});
      return {};
    }
    for (Vec3& delta : all_deltas) delta = 1 / unit * delta;
    const std::vector<Vec3> targets = scaled(1 / unit, anchor_positions);
    DELTAMESH_CHECK(settle_scaled(all_deltas, targets, x));
    for (Vec3& v : x) v = unit * v;
    return {};
  }

  Result<void> settle_scaled(const DeltaView& deltas, std::span<const Vec3> targets, std::span<Vec3> x) {
    std::fill(x.begin(), x.end(), Vec3{});
    Steps steps(graph_, components_, anchors_, deltas, targets);
    const Settling settling(graph_, components_, deltas, targets);
    // Conjugate gradients alone show what is left only at their end.
    const std::size_t fewest =
        planned_ ? 1 : std::min<std::size_t>(x.size(), multigrid::kFewestNodesToCoarsen);
    double before = 0;
    for (std::size_t round = 0; round < kMostRounds; ++round) {
      std::vector<Vec3> change = scaled(-1, x);
      make_round(steps, x);
      for (std::size_t i = 0; i < x.size(); ++i) change[i] = change[i] + x[i];
      const std::vector<Change> changes = measure(components_, change);
      const double worst = settling.worst(changes);
      if (!std::isfinite(worst)) return {};  // the caller finds positions that are not finite
      const double rate = worst / std::exchange(before, worst);
      if (round >= fewest && settling.is_settled(changes, rate, steps, x)) return {};
    }
    return Error{.code = ErrorCode::kInvalidStream,
                 .message = "the least-squares solution is out of reach",
                 .rule = "DELT-4"};
  }

  /// In units in which the residuals are of a size that suits floats.
  void step_by_cycle(Steps& steps, std::span<Vec3> x) {
    const double unit = unit_for(steps.residual(), steps.gaps());
    const std::vector<Vec3> deltas = scaled(1 / unit, steps.residual());
    planned_->solve(deltas, scaled(1 / unit, steps.gaps()), 1).write(steps.proposed());
    for (Vec3& step : steps.proposed()) step = unit * step;
    steps.take(x);
  }

  void make_round(Steps& steps, std::span<Vec3> x) {
    if (planned_) step_by_cycle(steps, x);
    for (int step = 0; step < kGradientSteps; ++step) {
      steps.propose_gradient();
      steps.take(x);
    }
  }

  const Adjacency& graph_;
  Components components_;
  std::vector<std::uint32_t> anchors_;
  std::vector<multigrid::Level> levels_;
  std::optional<PlannedCycles> planned_;
};

}  // namespace

Result<std::unique_ptr<LeastSquaresSolver>> make_multigrid_solver(const Adjacency& graph,
                                                                  std::span<const std::uint32_t> anchors) {
  return make_solver_for_components(graph, find_components(graph), anchors);
}

Result<std::unique_ptr<LeastSquaresSolver>> make_solver_for_components(
    const Adjacency& graph, Components components, std::span<const std::uint32_t> anchors) {
  return std::unique_ptr<LeastSquaresSolver>(
      std::make_unique<MultigridSolver>(graph, std::move(components), anchors));
}

}  // namespace deltamesh
