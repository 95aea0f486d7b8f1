// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/level_solver.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "laplacian/settling/hierarchy.h"
#include "laplacian/settling/smoother.h"
#include "laplacian/settling/transfer.h"

namespace deltamesh::settling {
namespace {

/// Nodes of a component on a coarsest level whose factor is quickly made, however many there are.
constexpr std::uint32_t kSmallComponent = 24;

/// A coarsest level has about as many nodes as anchors, which few iterations solve well enough. Where cycles
/// converge badly a nearly exact solution of a larger one is worth more.
constexpr CoarsestEffort kUsualEffort{.largest_factored = 200, .reduction = 1e-3};
constexpr CoarsestEffort kEffortWhenHard{.largest_factored = 100000, .reduction = 1e-5};
constexpr CoarsestEffort kLastEffort{.largest_factored = std::numeric_limits<std::uint32_t>::max(),
                                     .reduction = 1e-5};

/// Conjugate gradients on a coarsest level: at a time, and, over nodes and cycles together, for every vertex.
/// The time of a solution is linear so, however badly the anchors lie.
constexpr std::uint64_t kFewestIterations = 4;
constexpr std::uint64_t kMostIterations = 200;
constexpr std::uint64_t kIterationsPerVertex = 600;

/// A larger coarsest level has no more nodes for every anchor: conjugate gradients would take too long.
constexpr std::size_t kMostNodesPerAnchor = 24;

}  // namespace

LevelSolver::LevelSolver(std::span<const Level> levels, std::size_t first, std::vector<std::uint8_t> holds,
                         std::uint32_t component_count, bool is_last_resort)
    : levels_(levels),
      holds_(std::move(holds)),
      component_count_(component_count),
      is_last_resort_(is_last_resort),
      cycles_(plan_cycles(levels)),
      vectors_(levels.size()),
      two_steps_(levels.size()),
      bottom_(levels.size() - 1),
      coarsest_(levels.size()) {
  make_coarsest();  // takes much memory for a while, so before the others
  for (std::size_t level = first; level < levels_.size(); ++level) {
    vectors_[level].b.resize(levels_[level].node_count(), Row{});
    vectors_[level].u.resize(levels_[level].node_count(), Row{});
    vectors_[level].gaps.resize(holds_.size());
    vectors_[level].forces.resize(holds_.size());
    if (cycles_[level] == 2) two_steps_[level] = std::make_unique<TwoSteps>(levels_[level]);
  }
}

CoarsestEffort LevelSolver::effort() const noexcept {
  if (is_last_resort_) return kLastEffort;
  if (bottom_ + 1 < levels_.size()) return kEffortWhenHard;
  return {.largest_factored = std::max(kUsualEffort.largest_factored, kSmallComponent * component_count_),
          .reduction = kUsualEffort.reduction};
}

void LevelSolver::begin() noexcept {
  bottom_ = levels_.size() - 1;
  iterations_left_ = kIterationsPerVertex * levels_.front().node_count();
}

void LevelSolver::make_coarsest() {
  if (!coarsest_[bottom_])
    coarsest_[bottom_] = std::make_unique<CoarsestSolver>(levels_[bottom_], holds_, effort());
}

void LevelSolver::solve_coarsest() {
  make_coarsest();
  Vectors& v = vectors_[bottom_];
  const std::uint64_t nodes = levels_[bottom_].node_count();
  const std::uint64_t most = std::clamp(iterations_left_ / nodes, kFewestIterations, kMostIterations);
  const std::uint64_t made =
      nodes * coarsest_[bottom_]->solve(v.b, v.gaps, v.u, v.forces, static_cast<std::uint32_t>(most));
  iterations_left_ -= std::min(made, iterations_left_);
}

LevelProblem LevelSolver::problem(std::size_t level) noexcept {
  Vectors& v = vectors_[level];
  return {levels_[level], v.b, v.u, v.gaps, v.forces};
}

void LevelSolver::correct_from_next(std::size_t level) {
  const Level& fine = levels_[level];
  Vectors& v = vectors_[level];
  Vectors& next = vectors_[level + 1];
  for (std::size_t a = 0; a < next.gaps.size(); ++a) next.gaps[a] = v.gaps[a] - v.u[fine.anchors[a]].x;
  solve(level + 1);
  add_prolonged_rows(fine, next.u, v.u);
  for (std::size_t a = 0; a < v.forces.size(); ++a) {
    v.forces[a] = next.forces[a];
    v.b[fine.anchors[a]].s += next.forces[a];
  }
  smooth(fine, v.b, v.u);
}

/// A cycle from zero.
void LevelSolver::correct(std::size_t level) {
  const Level& fine = levels_[level];
  Vectors& v = vectors_[level];
  smooth_from_zero(fine, v.b, v.u);
  restrict_residual_from_zero(fine, v.b, v.u, vectors_[level + 1].b);
  correct_from_next(level);
}

void LevelSolver::solve(std::size_t level) {
  if (level == bottom_) {
    solve_coarsest();
    return;
  }
  correct(level);
  if (cycles_[level] < 2) return;
  two_steps_[level]->take_first(problem(level));
  correct(level);
  two_steps_[level]->combine(problem(level));
}

bool LevelSolver::drop_coarsest() {
  if (bottom_ < 2) return false;
  const std::uint32_t nodes = levels_[bottom_ - 1].node_count();
  if (nodes > kEffortWhenHard.largest_factored && nodes > kMostNodesPerAnchor * holds_.size()) return false;
  --bottom_;
  return true;
}

}  // namespace deltamesh::settling
