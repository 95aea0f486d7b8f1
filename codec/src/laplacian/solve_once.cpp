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
  std::vector<std::uint32_t> vertices{};  ///< ascending
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
  for (std::uint32_t v = 0; v < problem.graph.vertex_count(); ++v) {
    const auto found = std::lower_bound(depths.begin(), depths.end(), depth[problem.components.label[v]]);
    sets[static_cast<std::size_t>(found - depths.begin())].vertices.push_back(v);
  }
  return sets;
}

/// Anchors and targets of `problem` on `vertices`, renumbered.
void pick_anchors(const LeastSquaresProblem& problem, std::span<const std::uint32_t> vertices,
                  LeastSquaresProblem& part) {
  auto from = vertices.begin();
  for (std::size_t a = 0; a < problem.anchors.size(); ++a) {
    from = std::lower_bound(from, vertices.end(), problem.anchors[a]);
    if (from == vertices.end()) break;
    if (*from != problem.anchors[a]) continue;
    part.anchors.push_back(static_cast<std::uint32_t>(from - vertices.begin()));
    part.targets.push_back(problem.targets[a]);
  }
}

LeastSquaresProblem copy_part(const LeastSquaresProblem& problem, std::span<const std::uint32_t> vertices) {
  LeastSquaresProblem part{.graph = copy_vertices(problem.graph, vertices),
                           .components = pick_components(problem.components, vertices)};
  pick_anchors(problem, vertices, part);
  part.symbols.resize(3 * vertices.size());
  part.scale = problem.scale;
  part.half_cycles = problem.half_cycles;
  pick_symbols(problem.symbols, vertices, part.symbols);
  return part;
}

void keep_part(LeastSquaresProblem& problem, std::span<const std::uint32_t> vertices) {
  LeastSquaresProblem part;
  pick_anchors(problem, vertices, part);
  problem.anchors = std::move(part.anchors);
  problem.targets = std::move(part.targets);
  pick_symbols(problem.symbols, vertices, problem.symbols);
  problem.symbols.resize(3 * vertices.size());
  keep_vertices(problem.graph, vertices);
  problem.components = pick_components(problem.components, vertices);
}

/// Takes the components.
Result<LargeVector<Vec3>> solve(LeastSquaresProblem& problem, std::size_t size) {
  DELTAMESH_TRY(const auto solver,
                make_solver_for_components(problem.graph, std::move(problem.components), problem.anchors));
  return solver->solve_last(DeltaView(problem.symbols, problem.scale), problem.targets, problem.half_cycles,
                            size);
}

}  // namespace

Result<LargeVector<Vec3>> solve_once(LeastSquaresProblem problem, std::size_t size) {
  std::vector<Set> sets = collect_sets(problem);
  if (sets.size() <= 1) return solve(problem, size);
  // The largest set comes last, in place of the whole.
  std::stable_sort(sets.begin(), sets.end(),
                   [](const Set& a, const Set& b) { return a.vertices.size() < b.vertices.size(); });
  std::vector<std::uint32_t> largest = std::move(sets.back().vertices);
  sets.pop_back();
  std::vector<LargeVector<Vec3>> solutions(sets.size());
  for (std::size_t s = 0; s < sets.size(); ++s) {
    LeastSquaresProblem part = copy_part(problem, sets[s].vertices);
    DELTAMESH_TRY(solutions[s], solve(part, sets[s].vertices.size()));
  }
  const std::size_t rows = problem.graph.vertex_count();
  keep_part(problem, largest);
  const std::vector<bool> is_in_largest = mark_vertices(std::exchange(largest, {}), rows);
  DELTAMESH_TRY(LargeVector<Vec3> x, solve(problem, size));
  problem = {};
  spread_to_marks(std::span(x).first(rows), is_in_largest);
  for (std::size_t s = 0; s < sets.size(); ++s) {
    for (std::size_t i = 0; i < solutions[s].size(); ++i) x[sets[s].vertices[i]] = solutions[s][i];
  }
  return x;
}

}  // namespace deltamesh
