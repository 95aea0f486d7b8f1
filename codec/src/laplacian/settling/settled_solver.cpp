// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/settled_solver.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "laplacian/settling/convergence.h"
#include "laplacian/settling/coupled_factor.h"
#include "laplacian/settling/steps.h"
#include "topology/subgraph.h"
#include "topology/vertex_subset.h"

namespace deltamesh::settling {
namespace {

using multigrid::Level;

/// By cycles; most meshes take four to seven. By a factorisation, which only rounding keeps from being exact.
constexpr int kMostSteps = 60;
constexpr int kMostDirectSteps = 8;

/// After the last step, this many times what Convergence allows is still accepted: less than a quarter of
/// the errors to expect [DELT-6].
constexpr double kMostExcess = 4;

/// Factor after step 3 if at most 1/16 of the vertices are unsettled, after step 13 in any case.
bool is_time_to_factor(int step, std::size_t unsettled, std::size_t vertices) noexcept {
  return (step == 3 && 16 * unsettled <= vertices) || step == 13;
}

/// Levels with fewer nodes for each anchor that shares its component would tell too little of what is between
/// them: their forces would be wrong.
constexpr std::size_t kFewestNodesPerSharedAnchor = 3;

std::span<const Level> rich_levels(std::span<const Level> levels, std::span<const std::uint8_t> holds) {
  const auto shared = static_cast<std::size_t>(std::count(holds.begin(), holds.end(), 1));
  while (levels.size() > 1 && levels.back().node_count() < kFewestNodesPerSharedAnchor * shared)
    levels = levels.first(levels.size() - 1);
  return levels;
}

/// A power of 2 near the largest number, so that no square overflows; not finite where a number is not.
double unit_of(const DeltaView& deltas, std::span<const Vec3> targets) noexcept {
  double largest = 0;
  double nothing = 0;  // the sum of what is 0 where numbers are finite, else not a number
  const auto see = [&](const Vec3& v) {
    largest = std::max({largest, std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
    nothing += 0 * (v[0] + v[1] + v[2]);
  };
  for (std::size_t i = 0; i < deltas.size(); ++i) see(deltas[i]);
  for (const Vec3& target : targets) see(target);
  return (largest > 0 && std::isfinite(largest) ? std::ldexp(1.0, std::ilogb(largest)) : 1.0) + nothing;
}

/// Square of a delta's error on one axis that is to be expected at the most: that of rounding, where steps
/// are known, and what the start leaves, x being 0.
double noise_of(const DeltaView& deltas, double unit, const Steps& start, std::size_t anchors) noexcept {
  double functional = 0;
  for (const Progress& p : start.progress()) functional += p.functional;
  const double share = functional / (3.0 * static_cast<double>(deltas.size() + anchors));
  const double step = deltas.scale().step / unit;
  return deltas.has_symbols() ? std::min(share, step * step / 12) : share;
}

Vec3 position(double unit, const Double4& x) noexcept {
  return {unit * x.xy[0], unit * x.xy[1], unit * x.zw[0]};
}

Error out_of_reach() {
  return {.code = ErrorCode::kInvalidStream,
          .message = "the least-squares solution is out of reach",
          .rule = "DELT-4"};
}

VertexSubset vertices_of(const Components& components, std::span<const std::uint8_t> marks) {
  VertexSubset vertices;
  for_each_run(components, [&](std::uint32_t begin, std::uint32_t end, std::uint32_t component) {
    if (marks[component] != 0) vertices.append(begin, end);
  });
  return vertices;
}

}  // namespace

SettledSolver::SettledSolver(const Adjacency& graph, const Components& components,
                             std::span<const std::uint32_t> anchors, std::span<const Level> levels,
                             const std::vector<std::uint8_t>& holds, ThreadTeam* team)
    : graph_(graph),
      components_(components),
      anchors_(anchors),
      cycles_(rich_levels(levels, holds), holds, components.label, team) {}

Result<void> SettledSolver::solve(const DeltaView& deltas, std::span<const Vec3> targets, std::span<Vec3> x) {
  const double unit = unit_of(deltas, targets);
  if (!std::isfinite(unit)) {  // the caller finds positions that are not finite
    std::fill(x.begin(), x.end(), Vec3{unit, unit, unit});
    return {};
  }
  Steps steps(graph_, components_, anchors_, deltas, targets, unit);
  const double noise = noise_of(deltas, unit, steps, anchors_.size());
  Convergence convergence(components_, anchors_.size(), noise);
  bool is_settled = false;
  bool is_left = false;  // to a factorisation
  for (int step = 1; step <= kMostSteps && !is_settled && !is_left; ++step) {
    steps.set_residual(cycles_.first());
    cycles_.cycle();
    steps.take(cycles_.first());
    is_settled = convergence.see(steps.progress());
    if (is_settled || !is_time_to_factor(step, convergence.unsettled_vertices(), x.size())) continue;
    is_left = solve_directly({deltas, targets, unit, noise}, convergence.unsettled(1), x);
  }
  const std::vector<std::uint8_t> left = convergence.unsettled(is_left ? 1 : kMostExcess);
  if (!is_left && std::count(left.begin(), left.end(), 1) > 0) return out_of_reach();
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!is_left || left[components_.label[i]] == 0) x[i] = position(unit, steps.x()[i]);
  }
  return {};
}

/// Components with marks, as a problem of their own; whether that can be solved.
bool SettledSolver::solve_directly(const Problem& problem, std::span<const std::uint8_t> marks,
                                   std::span<Vec3> x) const {
  const VertexSubset vertices = vertices_of(components_, marks);
  const Adjacency graph = copy_vertices(graph_, vertices);
  const Components components = pick_components(components_, vertices);
  std::vector<std::uint32_t> anchors;
  std::vector<Vec3> targets;
  for (std::size_t a = 0; a < anchors_.size(); ++a) {
    if (marks[components_.label[anchors_[a]]] == 0) continue;
    anchors.push_back(*vertices.row_of(anchors_[a]));
    targets.push_back(problem.targets[a]);
  }
  auto factor = CoupledFactor::make(graph, anchors);
  if (!factor) return false;
  std::vector<Vec3> deltas;
  for (std::uint32_t row = 0; row < vertices.size(); ++row)
    deltas.push_back(problem.deltas[vertices.vertex(row)]);
  Steps steps(graph, components, anchors, deltas, targets, problem.unit);
  Convergence convergence(components, anchors.size(), problem.noise);
  bool is_settled = false;
  for (int step = 0; step < kMostDirectSteps && !is_settled; ++step) {
    steps.set_residual(factor->first());
    factor->solve();
    steps.take(factor->first());
    is_settled = convergence.see(steps.progress());
  }
  for (std::uint32_t row = 0; row < vertices.size(); ++row)
    x[vertices.vertex(row)] = position(problem.unit, steps.x()[row]);
  return is_settled;
}

}  // namespace deltamesh::settling
