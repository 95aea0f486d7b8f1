// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid/cycle/level_solver.h"

#include <algorithm>

#include "base/threads/thread_team.h"
#include "laplacian/multigrid/level/edges.h"

namespace deltamesh::multigrid {
namespace {

/// Two cycles double the work on all coarser levels: no more in all than that on this one, times their
/// number. Not of the first level, where most of the work is.
bool takes_two_cycles(const Level& level, const Level& next) noexcept {
  return 2 * next.edge_count() <= level.edge_count();
}

Row scaled(Float4 length, const Row& row) noexcept { return {length * row.x, length * row.s}; }

/// Solves the equations of a node, given what its neighbours add up to.
Row relax(const Level& level, std::uint32_t i, const Row& b, const Row& sum) noexcept {
  const float inverse = level.inverse_degree[i];
  const Float4 s = inverse * (sum.s + b.s);
  return {inverse * (sum.x + b.x - level.mass[i] * s), s};
}

/// One Gauss-Seidel sweep on both fields at once: at every node first s from K s = b.s, then x from
/// K x + M s = b.x. `u`, `b`: n. O(n + edges).
void sweep(const Level& level, std::span<const Row> b, std::span<Row> u) {
  const Edges edges(level);
  for (std::uint32_t i = 0; i < level.node_count(); ++i) {
    const Row sum = edges.sum_all(i, [&](std::uint32_t other) { return u[other]; });
    u[i] = relax(level, i, b[i], sum);
  }
}

/// The same from u = 0, whatever is there: half the work.
void sweep_from_zero(const Level& level, std::span<const Row> b, std::span<Row> u) {
  const Edges edges(level);
  for (std::uint32_t i = 0; i < level.node_count(); ++i) {
    const Row sum = edges.sum_lower(i, [&](std::uint32_t other) { return u[other]; });
    u[i] = relax(level, i, b[i], sum);
  }
}

/// coarse = P^T (b - [K M; 0 K] u) right after sweep_from_zero(): of every equation only what the higher
/// neighbours changed since is left. Half the work again.
void restrict_from_zero(const Level& level, std::span<const Row> u, std::span<Row> coarse) {
  const Edges edges(level);
  std::fill(coarse.begin(), coarse.end(), Row{});
  for (std::uint32_t i = 0; i < level.node_count(); ++i) {
    const Row residual = edges.sum_higher(i, [&](std::uint32_t other) { return u[other]; });
    level.interpolation[i].spread(residual, [&](std::uint32_t node) -> Row& { return coarse[node]; });
  }
}

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
