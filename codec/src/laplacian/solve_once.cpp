// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/solve_once.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "base/try.h"
#include "laplacian/multigrid_groups.h"
#include "laplacian/solver.h"
#include "topology/subgraph.h"

namespace deltamesh {
namespace {

/// Components that take the same hierarchy.
struct Set {
  std::uint32_t depth = 0;
  VertexSubset vertices{};
};

std::vector<Set> collect_sets(const LeastSquaresProblem& problem) {
  const std::vector<std::uint32_t> depth =
      multigrid::component_depths(problem.graph, problem.components, problem.anchors);
  std::vector<std::uint32_t> depths = depth;
  std::sort(depths.begin(), depths.end());
  depths.erase(std::unique(depths.begin(), depths.end()), depths.end());
  std::vector<Set> sets;
  for (const std::uint32_t d : depths) sets.push_back({.depth = d});
  if (sets.size() <= 1) return sets;
  for_each_run(problem.components, [&](std::uint32_t begin, std::uint32_t end, std::uint32_t component) {
    const auto found = std::lower_bound(depths.begin(), depths.end(), depth[component]);
    sets[static_cast<std::size_t>(found - depths.begin())].vertices.append(begin, end);
  });
  return sets;
}

/// The problem on `vertices`, renumbered, without a graph.
LeastSquaresProblem pick_but_graph(const LeastSquaresProblem& problem, const VertexSubset& vertices) {
  LeastSquaresProblem part{.components = pick_components(problem.components, vertices),
                           .symbols = problem.symbols.pick(vertices),
                           .scale = problem.scale,
                           .half_cycles = problem.half_cycles};
  SubsetWalk walk(vertices);
  for (std::size_t a = 0; a < problem.anchors.size(); ++a) {
    const auto row = walk.row_of(problem.anchors[a]);
    if (!row) continue;
    part.anchors.push_back(*row);
    part.targets.push_back(problem.targets[a]);
  }
  return part;
}

LeastSquaresProblem copy_part(const LeastSquaresProblem& problem, const VertexSubset& vertices) {
  LeastSquaresProblem part = pick_but_graph(problem, vertices);
  part.graph = copy_vertices(problem.graph, vertices);
  return part;
}

void keep_part(LeastSquaresProblem& problem, const VertexSubset& vertices) {
  Adjacency graph = std::move(problem.graph);
  keep_vertices(graph, vertices);
  problem = pick_but_graph(problem, vertices);
  problem.graph = std::move(graph);
}

/// Takes the components.
Result<LargeVector<Vec3>> solve(LeastSquaresProblem& problem, std::size_t size) {
  DELTAMESH_TRY(const auto solver,
                make_solver_for_components(problem.graph, std::move(problem.components), problem.anchors));
  return solver->solve_last(DeltaView(problem.symbols.view(), problem.scale), problem.targets,
                            problem.half_cycles, size);
}

}  // namespace

Result<LargeVector<Vec3>> solve_once(LeastSquaresProblem problem, std::size_t size) {
  std::vector<Set> sets = collect_sets(problem);
  if (sets.size() <= 1) return solve(problem, size);
  // The largest set comes last, in place of the whole.
  std::stable_sort(sets.begin(), sets.end(),
                   [](const Set& a, const Set& b) { return a.vertices.size() < b.vertices.size(); });
  const VertexSubset largest = std::move(sets.back().vertices);
  sets.pop_back();
  std::vector<LargeVector<Vec3>> solutions(sets.size());
  for (std::size_t s = 0; s < sets.size(); ++s) {
    LeastSquaresProblem part = copy_part(problem, sets[s].vertices);
    DELTAMESH_TRY(solutions[s], solve(part, sets[s].vertices.size()));
  }
  keep_part(problem, largest);
  DELTAMESH_TRY(LargeVector<Vec3> x, solve(problem, size));
  spread_rows(largest, std::span(x));
  for (std::size_t s = 0; s < sets.size(); ++s)
    scatter_rows(std::span<const Vec3>(solutions[s]), sets[s].vertices, std::span(x));
  return x;
}

}  // namespace deltamesh
