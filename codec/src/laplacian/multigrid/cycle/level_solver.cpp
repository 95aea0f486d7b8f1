// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid/cycle/level_solver.h"

#include "base/threads/thread_team.h"
#include "laplacian/multigrid/cycle/coupled_sweep.h"

namespace deltamesh::multigrid {
namespace {

/// Two cycles double the work on all coarser levels: no more in all than that on this one, times their
/// number. Not of the first level, where most of the work is.
bool takes_two_cycles(const Level& level, const Level& next) noexcept {
  return 2 * next.edge_count() <= level.edge_count();
}

Row scaled(Float4 length, const Row& row) noexcept { return {length * row.x, length * row.s}; }

}  // namespace

LevelSolver::LevelSolver(std::span<const Level> levels, ThreadTeam* team)
    : levels_(levels), vectors_(levels.size()), coarsest_(levels.back()), team_(team) {
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
  restrict_from_zero(fine, v.u, next.b);
  for (std::size_t a = 0; a < v.gaps.size(); ++a) next.gaps[a] = v.gaps[a] - v.u[fine.anchors[a]].x;
  solve(level + 1);
  share_each(team_, v.u.size(), [&](std::uint32_t i) { v.u[i] += fine.interpolation[i].of(next.u); });
  for (std::size_t a = 0; a < v.gaps.size(); ++a) {
    v.forces[a] = next.forces[a];
    v.b[fine.anchors[a]].s += next.forces[a];
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
  const Float4 first = best_length(problem(level), v.image);
  if (v.first.empty()) {
    share_each(team_, v.u.size(), [&](std::uint32_t i) { v.u[i] = scaled(first, v.u[i]); });
    for (Float4& force : v.forces) force = first * force;
    return;
  }
  share_each(team_, v.u.size(), [&](std::uint32_t i) { v.first[i] = scaled(first, v.u[i]); });
  for (std::size_t a = 0; a < v.forces.size(); ++a) v.first_forces[a] = first * v.forces[a];
  take_off(problem(level), first, v.image, team_);
  cycle(level);
  const Float4 second = best_length(problem(level), v.image);
  share_each(team_, v.u.size(), [&](std::uint32_t i) { v.u[i] = v.first[i] + scaled(second, v.u[i]); });
  for (std::size_t a = 0; a < v.forces.size(); ++a) v.forces[a] = v.first_forces[a] + second * v.forces[a];
}

}  // namespace deltamesh::multigrid
