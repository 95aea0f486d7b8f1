// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid_cycle.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "laplacian/multigrid_hierarchy.h"
#include "laplacian/multigrid_smoother.h"
#include "laplacian/multigrid_transfer.h"

namespace deltamesh::multigrid {
namespace {

/// Sweeps on the finest level before a correction: what interpolation leaves there must not reach coarser
/// levels.
constexpr int kFirstSweeps = 3;

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

/// Per anchor, whether its component has another.
std::vector<std::uint8_t> shared_components(const Components& components,
                                            std::span<const std::uint32_t> anchors) {
  std::vector<std::uint32_t> count(components.count, 0);
  for (const std::uint32_t anchor : anchors) ++count[components.label[anchor]];
  std::vector<std::uint8_t> shared;
  for (const std::uint32_t anchor : anchors) shared.push_back(count[components.label[anchor]] > 1 ? 1 : 0);
  return shared;
}

}  // namespace

MultigridCycle::MultigridCycle(const Adjacency& graph, const Components& components,
                               std::span<const std::uint32_t> anchors, std::uint32_t depth)
    : holds_(shared_components(components, anchors)),
      is_last_resort_(depth == 0),
      component_count_(components.count),
      levels_(build_hierarchy(graph, anchors, depth)),
      cycles_(plan_cycles(levels_)),
      vectors_(levels_.size()),
      targets_(anchors.size()),
      two_steps_(levels_.size()),
      bottom_(levels_.size() - 1),
      coarsest_(levels_.size()) {
  for (std::size_t level = 0; level < levels_.size(); ++level) {
    vectors_[level].b.resize(levels_[level].node_count());
    vectors_[level].u.resize(levels_[level].node_count());
    vectors_[level].gaps.resize(anchors.size());
    vectors_[level].forces.resize(anchors.size());
    if (cycles_[level] == 2) two_steps_[level] = std::make_unique<TwoSteps>(levels_[level]);
  }
}

CoarsestEffort MultigridCycle::effort() const noexcept {
  if (is_last_resort_) return kLastEffort;
  if (bottom_ + 1 < levels_.size()) return kEffortWhenHard;
  return {.largest_factored = std::max(kUsualEffort.largest_factored, kSmallComponent * component_count_),
          .reduction = kUsualEffort.reduction};
}

void MultigridCycle::solve_coarsest() {
  if (!coarsest_[bottom_])
    coarsest_[bottom_] = std::make_unique<CoarsestSolver>(levels_[bottom_], holds_, effort());
  Vectors& v = vectors_[bottom_];
  const std::uint64_t nodes = levels_[bottom_].node_count();
  const std::uint64_t most = std::clamp(iterations_left_ / nodes, kFewestIterations, kMostIterations);
  const std::uint64_t made =
      nodes * coarsest_[bottom_]->solve(v.b, v.gaps, v.u, v.forces, static_cast<std::uint32_t>(most));
  iterations_left_ -= std::min(made, iterations_left_);
}

LevelProblem MultigridCycle::problem(std::size_t level) noexcept {
  Vectors& v = vectors_[level];
  return {levels_[level], v.b, v.u, v.gaps, v.forces};
}

void MultigridCycle::correct(std::size_t level) {
  const Level& fine = levels_[level];
  Vectors& v = vectors_[level];
  Vectors& next = vectors_[level + 1];
  if (level == 0) {
    for (int sweep = 0; sweep < kFirstSweeps; ++sweep) smooth(fine, v.b, v.u);
    restrict_residual(fine, v.b, v.u, next.b);
  } else {
    smooth_from_zero(fine, v.b, v.u);
    restrict_residual_from_zero(fine, v.b, v.u, next.b);
  }
  for (std::size_t a = 0; a < next.gaps.size(); ++a) next.gaps[a] = v.gaps[a] - v.u[fine.anchors[a]].x;
  solve(level + 1);
  add_prolonged_rows(fine, next.u, v.u);
  for (std::size_t a = 0; a < v.forces.size(); ++a) {
    v.forces[a] = next.forces[a];
    v.b[fine.anchors[a]].s += next.forces[a];
  }
  smooth(fine, v.b, v.u);
}

void MultigridCycle::solve(std::size_t level) {
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

void MultigridCycle::start() {
  bottom_ = levels_.size() - 1;
  iterations_left_ = kIterationsPerVertex * levels_.front().node_count();
  Vectors& finest = vectors_.front();
  for (const std::uint32_t anchor : levels_.front().anchors) finest.b[anchor].s = Float4{};
  if (bottom_ > 0) {
    restrict_rows(levels_.front(), finest.b, vectors_[1].b);
    vectors_[1].gaps = targets_;
    solve(1);
    prolong_rows(levels_.front(), vectors_[1].u, finest.u);
    finest.forces = vectors_[1].forces;
  } else {
    finest.gaps = targets_;
    solve(0);
  }
  for (std::size_t a = 0; a < finest.forces.size(); ++a) force(a) = finest.forces[a];
}

void MultigridCycle::cycle() {
  Vectors& finest = vectors_.front();
  for (std::size_t a = 0; a < finest.gaps.size(); ++a) finest.gaps[a] = targets_[a] + force(a);
  if (bottom_ > 0) {
    correct(0);
    return;
  }
  solve(0);
  for (std::size_t a = 0; a < finest.forces.size(); ++a) force(a) += finest.forces[a];
}

bool MultigridCycle::drop_coarsest() {
  if (bottom_ < 2) return false;
  const std::uint32_t nodes = levels_[bottom_ - 1].node_count();
  if (nodes > kEffortWhenHard.largest_factored && nodes > kMostNodesPerAnchor * targets_.size()) return false;
  --bottom_;
  return true;
}

}  // namespace deltamesh::multigrid
