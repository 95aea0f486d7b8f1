// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/settled_solver.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "laplacian/anchors/shared_components.h"
#include "laplacian/settling/convergence.h"
#include "laplacian/settling/coupled_factor.h"
#include "laplacian/settling/steps.h"
#include "topology/subgraph.h"
#include "topology/vertex_subset.h"

namespace deltamesh::settling {
namespace {

using multigrid::Level;

/// By cycles; most meshes take four to ten. By a factorisation, which only rounding keeps from being exact.
constexpr int kMostSteps = 40;
constexpr int kMostDirectSteps = 8;

/// Where so many steps by cycles leave few vertices, a factorisation of their components is soonest done.
constexpr int kPatience = 8;
constexpr std::size_t kFewVertices = 16;  ///< of so many, one

/// Levels with fewer nodes for each anchor that shares its component would tell too little of what is between
/// them: their forces would be wrong.
constexpr std::size_t kFewestNodesPerAnchor = 2;

std::span<const Level> without_poor_level(std::span<const Level> levels,
                                          std::span<const std::uint8_t> holds) {
  const auto shared = static_cast<std::size_t>(std::count(holds.begin(), holds.end(), 1));
  const bool is_poor = levels.back().node_count() < kFewestNodesPerAnchor * shared;
  return levels.first(levels.size() - (levels.size() > 1 && is_poor ? 1 : 0));
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
                             ThreadTeam* team)
    : graph_(graph),
      components_(components),
      anchors_(anchors),
      cycles_(without_poor_level(levels, shared_components(components, anchors)),
              shared_components(components, anchors), multigrid::LevelSolver::Lengths::kWhole, team) {}

Result<void> SettledSolver::solve(const DeltaView& deltas, std::span<const Vec3> targets, std::span<Vec3> x) {
  const double unit = unit_of(deltas, targets);
  if (!std::isfinite(unit)) {  // the caller finds positions that are not finite
    std::fill(x.begin(), x.end(), Vec3{unit, unit, unit});
    return {};
  }
  Steps steps(graph_, components_, anchors_, deltas, targets, unit);
  Convergence convergence(components_, anchors_);
  bool is_settled = false;
  for (int step = 0; step < kMostSteps && !is_settled; ++step) {
    steps.set_residual(cycles_.first());
    cycles_.cycle();
    steps.take(cycles_.first());
    is_settled = convergence.see(steps.progress());
    if (step + 1 >= kPatience && kFewVertices * convergence.unsettled_vertices() <= x.size()) break;
  }
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = position(unit, steps.x()[i]);
  if (is_settled || solve_directly(convergence.unsettled(false), deltas, targets, unit, x)) return {};
  const std::vector<std::uint8_t> bad = convergence.unsettled(true);
  if (std::count(bad.begin(), bad.end(), 1) > 0) return out_of_reach();
  return {};
}

/// Components with marks, as a problem of their own.
Result<void> SettledSolver::solve_directly(std::span<const std::uint8_t> marks, const DeltaView& deltas,
                                           std::span<const Vec3> targets, double unit,
                                           std::span<Vec3> x) const {
  const VertexSubset vertices = vertices_of(components_, marks);
  const Adjacency graph = copy_vertices(graph_, vertices);
  const Components components = pick_components(components_, vertices);
  std::vector<std::uint32_t> own_anchors;
  std::vector<Vec3> own_targets;
  for (std::size_t a = 0; a < anchors_.size(); ++a) {
    if (marks[components_.label[anchors_[a]]] == 0) continue;
    own_anchors.push_back(*vertices.row_of(anchors_[a]));
    own_targets.push_back(targets[a]);
  }
  auto factor = CoupledFactor::make(graph, own_anchors);
  if (!factor) return out_of_reach();
  std::vector<Vec3> own_deltas;
  for (std::uint32_t row = 0; row < vertices.size(); ++row)
    own_deltas.push_back(deltas[vertices.vertex(row)]);
  Steps steps(graph, components, own_anchors, own_deltas, own_targets, unit);
  Convergence convergence(components, own_anchors);
  bool is_settled = false;
  for (int step = 0; step < kMostDirectSteps && !is_settled; ++step) {
    steps.set_residual(factor->first());
    factor->solve();
    steps.take(factor->first());
    is_settled = convergence.see(steps.progress());
  }
  if (!is_settled) return out_of_reach();
  for (std::uint32_t row = 0; row < vertices.size(); ++row)
    x[vertices.vertex(row)] = position(unit, steps.x()[row]);
  return {};
}

}  // namespace deltamesh::settling
