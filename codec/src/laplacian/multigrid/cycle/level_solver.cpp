// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid/cycle/level_solver.h"

#include <utility>

#include "base/threads/thread_team.h"
#include "laplacian/multigrid/cycle/coupled_sweep.h"

namespace deltamesh::multigrid {
namespace {

/// Two cycles double the work on all coarser levels: no more in all than that on this one, times their
/// number. Not of the first level, where most of the work is.
bool takes_two_cycles(const Level& level, const Level& next) noexcept {
  return 2 * next.edge_count() <= level.edge_count();
}

/// Which anchors of the coarsest level hold, from those of the first.
std::vector<std::uint8_t> on_coarsest(std::span<const Level> levels, std::vector<std::uint8_t> holds) {
  for (const Level& level : levels.subspan(1)) {
    std::vector<std::uint8_t> coarser;
    for (const std::uint32_t anchor : level.finer_anchors) coarser.push_back(holds[anchor]);
    holds = std::move(coarser);
  }
  return holds;
}

/// Of each of the coarsest level's nodes the component, from those of the first.
std::vector<std::uint32_t> on_coarsest(std::span<const Level> levels,
                                       std::span<const std::uint32_t> components) {
  std::vector<std::uint32_t> result(components.begin(), components.end());
  if (components.empty()) return result;
  for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
    std::vector<std::uint32_t> coarser(levels[k + 1].node_count());
    for (std::size_t i = 0; i < result.size(); ++i) {
      const Interpolation& row = levels[k].interpolation[i];
      if (row.weight(0) > 0) coarser[row.node(0)] = result[i];
    }
    result = std::move(coarser);
  }
  return result;
}

Row scaled(Float4 length, const Row& row) noexcept { return {length * row.x, length * row.s}; }

}  // namespace

LevelSolver::LevelSolver(std::span<const Level> levels, std::vector<std::uint8_t> holds,
                         std::span<const std::uint32_t> components, ThreadTeam* team)
    : levels_(levels),
      vectors_(levels.size()),
      takes_whole_(!components.empty()),
      coarsest_(levels.back(), on_coarsest(levels, std::move(holds)), on_coarsest(levels, components)),
      team_(team) {
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    const Level& level = levels_[k];
    Vectors& v = vectors_[k];
    v.b.resize(level.node_count());
    v.u.resize(level.node_count());
    v.gaps.resize(level.anchors.size());
    v.forces.resize(level.anchors.size());
    if (k + 1 == levels_.size()) break;
    if (k == 0 || !takes_two_cycles(level, levels_[k + 1])) continue;
    v.first.resize(level.node_count());
    v.image.resize(level.node_count());
    v.first_forces.resize(level.anchors.size());
  }
}

CoupledProblem LevelSolver::problem(std::size_t level) noexcept {
  Vectors& v = vectors_[level];
  return {levels_[level], v.b, v.u, v.gaps, v.forces};
}

void LevelSolver::cycle(std::size_t level) {
  const Level& fine = levels_[level];
  Vectors& v = vectors_[level];
  Vectors& next = vectors_[level + 1];
  sweep_from_zero(fine, v.b, v.u);
  for (std::size_t a = 0; a < v.gaps.size(); ++a) {
    Row& u = v.u[fine.anchors[a]];
    if (fine.inverse_degree[fine.anchors[a]] == 0) u.x = v.gaps[a];
    v.forces[a] = Float4{};
  }
  restrict_from_zero(fine, v.b, v.u, next.b);
  const auto& kept = levels_[level + 1].finer_anchors;
  for (std::size_t a = 0; a < kept.size(); ++a) next.gaps[a] = v.gaps[kept[a]] - v.u[fine.anchors[kept[a]]].x;
  solve(level + 1);
  share_each(team_, v.u.size(), [&](std::uint32_t i) { v.u[i] += fine.interpolation[i].of(next.u); });
  for (std::size_t a = 0; a < kept.size(); ++a) {
    v.forces[kept[a]] = next.forces[a];
    v.b[fine.anchors[kept[a]]].s += next.forces[a];
  }
  sweep(fine, v.b, v.u);
}

void LevelSolver::solve(std::size_t level) {
  if (level + 1 == levels_.size()) {
    coarsest_.solve(problem(level));
    return;
  }
  Vectors& v = vectors_[level];
  cycle(level);
  constexpr Float4 kWhole{1, 1, 1, 1};
  if (v.first.empty()) {
    if (takes_whole_) return;
    const Float4 length = best_length(problem(level), v.image);
    share_each(team_, v.u.size(), [&](std::uint32_t i) { v.u[i] = scaled(length, v.u[i]); });
    for (Float4& force : v.forces) force = length * force;
    return;
  }
  const Float4 best = best_length(problem(level), v.image);  // which sets the image
  const Float4 first = takes_whole_ ? kWhole : best;
  share_each(team_, v.u.size(), [&](std::uint32_t i) { v.first[i] = scaled(first, v.u[i]); });
  for (std::size_t a = 0; a < v.forces.size(); ++a) v.first_forces[a] = first * v.forces[a];
  take_off(problem(level), first, v.image, team_);
  cycle(level);
  const Float4 second = takes_whole_ ? kWhole : best_length(problem(level), v.image);
  share_each(team_, v.u.size(), [&](std::uint32_t i) { v.u[i] = v.first[i] + scaled(second, v.u[i]); });
  for (std::size_t a = 0; a < v.forces.size(); ++a) v.forces[a] = v.first_forces[a] + second * v.forces[a];
}

}  // namespace deltamesh::multigrid
