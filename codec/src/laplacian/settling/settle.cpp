// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/settle.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/try.h"
#include "laplacian/anchors/anchors.h"
#include "laplacian/multigrid/cycle/level_solver.h"
#include "laplacian/multigrid/setup/levels.h"
#include "laplacian/settling/convergence.h"
#include "laplacian/settling/coupled_factor.h"
#include "laplacian/settling/steps.h"
#include "topology/subgraph.h"

namespace deltamesh::settling {
namespace {

using multigrid::Level;

/// By cycles; most meshes take four to seven. By a factorisation, which only rounding keeps from being exact.
constexpr int kMostSteps = 60;
constexpr int kMostDirectSteps = 8;

/// What a step leaves of the size of the one before, at the worst, as far as it is believed. The second step
/// by a factorisation is one of rounding, which does not become smaller.
constexpr double kHighestRate = 0.98;
constexpr double kHighestDirectRate = 0.5;

/// Multiplications of all factorisations: twice what one may take.
constexpr std::uint64_t kMostWork = std::uint64_t{1} << 33;

/// Vertices that are solved together, unless a component has more: what is known of them fits in a cache.
constexpr std::size_t kBatch = 4096;

/// After the last step, this many times what Convergence allows is still accepted: less than a quarter of
/// the errors to expect [DELT-6].
constexpr double kMostExcess = 4;

/// Factor after step 3 if at most 1/16 of the vertices solved for are unsettled, after step 13 in any case.
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
double unit_of(const Problem& problem) noexcept {
  double largest = 0;
  double nothing = 0;  // the sum of what is 0 where numbers are finite, else not a number
  const auto see = [&](const Vec3& v) {
    largest = std::max({largest, std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
    nothing += 0 * (v[0] + v[1] + v[2]);
  };
  for (std::size_t i = 0; i < problem.deltas.size(); ++i) see(problem.deltas[i]);
  for (const Vec3& target : problem.targets) see(target);
  return (largest > 0 && std::isfinite(largest) ? std::ldexp(1.0, std::ilogb(largest)) : 1.0) + nothing;
}

/// Square of a delta's error on one axis that is to be expected at the most: that of rounding, where steps
/// are known, and what the start leaves, x being 0.
double noise_of(const Problem& problem, double unit, const Steps& start) noexcept {
  double functional = 0;
  for (const Progress& p : start.progress()) functional += p.functional;
  const double step = problem.step / unit;
  return std::min(functional / (3.0 * static_cast<double>(problem.deltas.size() + problem.anchors.size())),
                  step * step / 12);
}

Vec3 position(double unit, const Double4& x) noexcept {
  return {unit * x.xy[0], unit * x.xy[1], unit * x.zw[0]};
}

Error out_of_reach() {
  return {.code = ErrorCode::kInvalidStream,
          .message = "the least-squares solution is out of reach",
          .rule = "DELT-4"};
}

/// Of the components that have marks.
VertexSubset vertices_of(const Components& components, std::span<const std::uint8_t> marks) {
  VertexSubset vertices;
  for_each_run(components, [&](std::uint32_t begin, std::uint32_t end, std::uint32_t component) {
    if (marks[component] != 0) vertices.append(begin, end);
  });
  return vertices;
}

/// The vertices of components that follow each other and have at least kBatch of them together; the last ones
/// may have fewer.
std::vector<VertexSubset> divide(const Components& components) {
  std::vector<std::uint32_t> batch_of;
  std::uint32_t batch = 0;
  std::size_t vertices = 0;
  for (const std::uint32_t size : components.size) {
    batch_of.push_back(batch);
    vertices += size;
    if (vertices < kBatch) continue;
    ++batch;
    vertices = 0;
  }
  std::vector<VertexSubset> batches(batch_of.back() + 1);
  for_each_run(components, [&](std::uint32_t begin, std::uint32_t end, std::uint32_t component) {
    batches[batch_of[component]].append(begin, end);
  });
  return batches;
}

/// `x`: rows of those components only. Whether that can be solved.
bool factor_and_solve(const PartialProblem& part, double unit, double noise, std::uint64_t& work_left,
                      std::span<Vec3> x) {
  const Problem problem = part.problem();
  auto factor = CoupledFactor::make(problem.graph, problem.anchors, work_left);
  if (!factor) return false;
  Steps steps(problem, unit);
  Convergence convergence(problem.components, problem.anchors, noise, kHighestDirectRate);
  bool is_settled = false;
  for (int step = 0; step < kMostDirectSteps && !is_settled; ++step) {
    steps.set_residual(factor->first());
    factor->solve();
    steps.take(factor->first());
    is_settled = convergence.see(steps.progress());
  }
  for (std::uint32_t row = 0; row < part.vertices().size(); ++row)
    x[part.vertices().vertex(row)] = position(unit, steps.x()[row]);
  return is_settled;
}

/// `work_left`: as SparseFactor::make.
Result<void> settle_together(const Problem& problem, ThreadTeam* team, std::uint64_t& work_left,
                             std::span<Vec3> x) {
  const double unit = unit_of(problem);
  if (!std::isfinite(unit)) {  // the caller finds positions that are not finite
    std::fill(x.begin(), x.end(), Vec3{unit, unit, unit});
    return {};
  }
  std::vector<Level> levels = multigrid::build_levels(problem.graph, problem.anchors, team);
  multigrid::add_weights(levels.front());
  const std::vector<std::uint8_t> holds = shared_anchors(problem.components, problem.anchors);
  multigrid::LevelSolver cycles(rich_levels(levels, holds), holds, problem.components.label, team);
  Steps steps(problem, unit);
  const double noise = noise_of(problem, unit, steps);
  Convergence convergence(problem.components, problem.anchors, noise, kHighestRate);
  bool is_settled = false;
  bool is_left = false;  // to a factorisation
  for (int step = 1; step <= kMostSteps && !is_settled && !is_left; ++step) {
    steps.set_residual(cycles.first());
    cycles.cycle();
    steps.take(cycles.first());
    is_settled = convergence.see(steps.progress());
    if (is_settled || !is_time_to_factor(step, convergence.unsettled_vertices(), x.size())) continue;
    const PartialProblem left(problem, vertices_of(problem.components, convergence.unsettled(1)));
    is_left = factor_and_solve(left, unit, noise, work_left, x);
  }
  const std::vector<std::uint8_t> left = convergence.unsettled(is_left ? 1 : kMostExcess);
  if (!is_left && std::count(left.begin(), left.end(), 1) > 0) return out_of_reach();
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!is_left || left[problem.components.label[i]] == 0) x[i] = position(unit, steps.x()[i]);
  }
  return {};
}

}  // namespace

Result<void> settle(const Problem& problem, ThreadTeam* team, std::span<Vec3> x) {
  std::uint64_t work_left = kMostWork;
  std::vector<VertexSubset> batches = divide(problem.components);
  if (batches.size() == 1) return settle_together(problem, team, work_left, x);
  for (VertexSubset& vertices : batches) {
    const PartialProblem batch(problem, std::move(vertices));
    std::vector<Vec3> rows(batch.vertices().size());
    DELTAMESH_CHECK(settle_together(batch.problem(), team, work_left, rows));
    scatter_rows<Vec3>(rows, batch.vertices(), x);
  }
  return {};
}

}  // namespace deltamesh::settling
