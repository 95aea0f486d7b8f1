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

/// Nodes of a coarsest level that is factored; where cycles converge badly an exact solution is worth more.
constexpr std::uint32_t kLargestFactored = 30000;
constexpr std::uint32_t kLargestFactoredWhenHard = 100000;

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
      levels_(build_hierarchy(graph, anchors, depth)),
      vectors_(levels_.size()),
      targets_(anchors.size()),
      gaps_(anchors.size()),
      forces_(anchors.size()),
      bottom_(levels_.size() - 1),
      coarsest_(levels_.size()) {
  for (std::size_t level = 0; level < levels_.size(); ++level) {
    vectors_[level].b.resize(levels_[level].node_count());
    vectors_[level].u.resize(levels_[level].node_count());
  }
}

std::uint32_t MultigridCycle::largest_factored() const noexcept {
  if (is_last_resort_) return std::numeric_limits<std::uint32_t>::max();
  return bottom_ + 1 < levels_.size() ? kLargestFactoredWhenHard : kLargestFactored;
}

void MultigridCycle::solve_coarsest() {
  if (!coarsest_[bottom_])
    coarsest_[bottom_] = std::make_unique<CoarsestSolver>(levels_[bottom_], holds_, largest_factored());
  const std::uint64_t nodes = levels_[bottom_].node_count();
  const std::uint64_t most = std::clamp(iterations_left_ / nodes, kFewestIterations, kMostIterations);
  const std::uint64_t made =
      nodes * coarsest_[bottom_]->solve(vectors_[bottom_].b, gaps_, vectors_[bottom_].u, forces_,
                                        static_cast<std::uint32_t>(most));
  iterations_left_ -= std::min(made, iterations_left_);
}

void MultigridCycle::descend(std::size_t level) {
  const std::vector<Row>& b = vectors_[level].b;
  std::vector<Row>& u = vectors_[level].u;
  smooth(levels_[level], b, u);
  restrict_residual(levels_[level], b, u, vectors_[level + 1].b);
  std::fill(vectors_[level + 1].u.begin(), vectors_[level + 1].u.end(), Row{});
  for (std::size_t a = 0; a < gaps_.size(); ++a) gaps_[a] -= u[levels_[level].anchors[a]].x;
}

void MultigridCycle::ascend(std::size_t level) {
  std::vector<Row>& b = vectors_[level].b;
  add_prolonged_rows(levels_[level], vectors_[level + 1].u, vectors_[level].u);
  for (std::size_t a = 0; a < forces_.size(); ++a) b[levels_[level].anchors[a]].s += forces_[a];
  smooth(levels_[level], b, vectors_[level].u);
}

void MultigridCycle::v_cycle(std::size_t top) {
  const Level& level = levels_[top];
  for (std::size_t a = 0; a < gaps_.size(); ++a) gaps_[a] = targets_[a] + vectors_[top].b[level.anchors[a]].s;
  for (std::size_t l = top; l < bottom_; ++l) descend(l);
  solve_coarsest();
  if (top == bottom_) {
    for (std::size_t a = 0; a < forces_.size(); ++a) vectors_[top].b[level.anchors[a]].s += forces_[a];
  }
  for (std::size_t l = bottom_; l-- > top;) ascend(l);
}

void MultigridCycle::start() {
  bottom_ = levels_.size() - 1;
  iterations_left_ = kIterationsPerVertex * levels_.front().node_count();
  for (const std::uint32_t anchor : levels_.front().anchors) vectors_.front().b[anchor].s = Float4{};
  for (std::size_t l = 0; l + 1 < levels_.size(); ++l)
    restrict_rows(levels_[l], vectors_[l].b, vectors_[l + 1].b);
  gaps_ = targets_;
  solve_coarsest();
  std::vector<Row>& coarsest = vectors_.back().b;
  for (std::size_t a = 0; a < forces_.size(); ++a) coarsest[levels_.back().anchors[a]].s = forces_[a];
  for (std::size_t l = levels_.size() - 1; l-- > 0;) {
    // Forces are the same on every level; v_cycle() lets them grow from here.
    for (std::size_t a = 0; a < forces_.size(); ++a)
      vectors_[l].b[levels_[l].anchors[a]].s = vectors_[l + 1].b[levels_[l + 1].anchors[a]].s;
    prolong_rows(levels_[l], vectors_[l + 1].u, vectors_[l].u);
    if (l > 0) v_cycle(l);
  }
}

void MultigridCycle::cycle() { v_cycle(0); }

bool MultigridCycle::drop_coarsest() {
  if (bottom_ < 2) return false;
  const std::uint32_t nodes = levels_[bottom_ - 1].node_count();
  if (nodes > kLargestFactoredWhenHard && nodes > kMostNodesPerAnchor * targets_.size()) return false;
  --bottom_;
  return true;
}

}  // namespace deltamesh::multigrid
