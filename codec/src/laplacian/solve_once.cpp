// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/solve_once.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "base/task.h"
#include "base/thread_team.h"
#include "base/try.h"
#include "laplacian/multigrid_groups.h"
#include "laplacian/solver.h"
#include "topology/subgraph.h"

namespace deltamesh {
namespace {

/// Some components that take the same hierarchy.
struct Part {
  VertexSubset vertices{};        ///< of the whole problem
  LeastSquaresProblem problem{};  ///< theirs, renumbered
};

using Solutions = std::vector<LargeVector<Vec3>>;

/// Vertices by the hierarchy they take, the largest set last; nothing where that is one for all.
std::vector<VertexSubset> collect_sets(const LeastSquaresProblem& problem) {
  const std::vector<std::uint32_t> depth =
      multigrid::component_depths(problem.graph, problem.components, problem.anchors);
  std::vector<std::uint32_t> depths = depth;
  std::sort(depths.begin(), depths.end());
  depths.erase(std::unique(depths.begin(), depths.end()), depths.end());
  if (depths.size() <= 1) return {};
  std::vector<VertexSubset> sets(depths.size());
  for_each_run(problem.components, [&](std::uint32_t begin, std::uint32_t end, std::uint32_t component) {
    const auto found = std::lower_bound(depths.begin(), depths.end(), depth[component]);
    sets[static_cast<std::size_t>(found - depths.begin())].append(begin, end);
  });
  std::stable_sort(sets.begin(), sets.end(),
                   [](const VertexSubset& a, const VertexSubset& b) { return a.size() < b.size(); });
  return sets;
}

/// The problem on `vertices`, renumbered, without a graph.
LeastSquaresProblem pick_but_graph(const LeastSquaresProblem& problem, const VertexSubset& vertices) {
  LeastSquaresProblem part{.components = pick_components(problem.components, vertices),
                           .scale = problem.scale,
                           .cycles = problem.cycles};
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

/// In the order of the sets; the last one takes the graph. Leaves nothing of the problem, or all.
std::vector<Part> take_apart(LeastSquaresProblem& problem) {
  std::vector<Part> parts;
  for (VertexSubset& set : collect_sets(problem)) parts.push_back({.vertices = std::move(set)});
  if (parts.empty()) return parts;
  Part& largest = parts.back();
  for (Part& part : std::span(parts).first(parts.size() - 1))
    part.problem = copy_part(problem, part.vertices);
  largest.problem = pick_but_graph(problem, largest.vertices);
  keep_vertices(problem.graph, largest.vertices);
  largest.problem.graph = std::move(problem.graph);
  problem = {};
  return parts;
}

/// The same, but leaves the problem as it is.
std::vector<Part> copy_parts(const LeastSquaresProblem& problem) {
  std::vector<Part> parts;
  for (VertexSubset& set : collect_sets(problem)) {
    LeastSquaresProblem part = copy_part(problem, set);
    parts.push_back({.vertices = std::move(set), .problem = std::move(part)});
  }
  return parts;
}

/// What takes longest, of the parts or of a problem that is not taken apart.
LeastSquaresProblem& largest_of(std::vector<Part>& parts, LeastSquaresProblem& whole) noexcept {
  return parts.empty() ? whole : parts.back().problem;
}

std::span<Part> all_but_last(std::vector<Part>& parts) noexcept {
  return std::span(parts).first(parts.empty() ? 0 : parts.size() - 1);
}

/// Takes the components.
auto make_solver(LeastSquaresProblem& problem) {
  return make_solver_for_components(problem.graph, std::move(problem.components), problem.anchors);
}

Result<LargeVector<Vec3>> solve(const LeastSquaresProblem& problem, LeastSquaresSolver& solver,
                                const SymbolRows& symbols, std::size_t size) {
  return solver.solve_last(DeltaView(symbols.view(), problem.scale), problem.targets, problem.cycles, size);
}

/// One after the other. `symbols`: of the whole problem. Leaves nothing of the parts but their vertices.
Result<Solutions> solve_each(std::span<Part> parts, const SymbolRows& symbols) {
  Solutions solutions;
  for (Part& part : parts) {
    LeastSquaresProblem problem = std::exchange(part.problem, {});
    DELTAMESH_TRY(const auto solver, make_solver(problem));
    DELTAMESH_TRY(auto x, solve(problem, *solver, symbols.pick(part.vertices), part.vertices.size()));
    solutions.push_back(std::move(x));
  }
  return solutions;
}

/// `x`: in front the solution of the last part.
void put_together(std::span<const Part> parts, const Solutions& others, std::span<Vec3> x) {
  if (parts.empty()) return;
  spread_rows(parts.back().vertices, x);
  for (std::size_t s = 0; s < others.size(); ++s)
    scatter_rows(std::span<const Vec3>(others[s]), parts[s].vertices, x);
}

/// Without a team.
Result<LargeVector<Vec3>> solve_alone(LeastSquaresProblem problem, const ReadSymbols& read_symbols,
                                      std::size_t size) {
  DELTAMESH_TRY(SymbolRows symbols, read_symbols(problem.graph));
  std::vector<Part> parts = take_apart(problem);
  DELTAMESH_TRY(const Solutions others, solve_each(all_but_last(parts), symbols));
  if (!parts.empty()) symbols = symbols.pick(parts.back().vertices);
  LeastSquaresProblem& largest = largest_of(parts, problem);
  DELTAMESH_TRY(const auto solver, make_solver(largest));
  DELTAMESH_TRY(auto x, solve(largest, *solver, symbols, size));
  put_together(parts, others, x);
  return x;
}

/// Whoever is free reads the symbols, then solves all but the largest part, beside this thread. Of several
/// errors it is the same one as without a team.
Result<LargeVector<Vec3>> solve_together(LeastSquaresProblem problem, const ReadSymbols& read_symbols,
                                         std::size_t size) {
  Task<Result<SymbolRows>> reading(ThreadTeam::current(), [&] { return read_symbols(problem.graph); });
  std::vector<Part> parts = copy_parts(problem);
  LeastSquaresProblem& largest = largest_of(parts, problem);
  auto made = make_solver(largest);
  if (made) (*made)->set_up(largest.cycles);
  DELTAMESH_TRY(const SymbolRows symbols, reading.get());
  if (!parts.empty()) problem = {};
  Task<Result<Solutions>> others(ThreadTeam::current(),
                                 [&] { return solve_each(all_but_last(parts), symbols); });
  const SymbolRows picked = parts.empty() ? SymbolRows() : symbols.pick(parts.back().vertices);
  auto solved = made ? solve(largest, **made, parts.empty() ? symbols : picked, size)
                     : Result<LargeVector<Vec3>>(made.error());
  DELTAMESH_TRY(const Solutions solutions, others.get());
  DELTAMESH_TRY(auto x, std::move(solved));
  put_together(parts, solutions, x);
  return x;
}

}  // namespace

Result<LargeVector<Vec3>> solve_once(LeastSquaresProblem problem, const ReadSymbols& read_symbols,
                                     std::size_t size) {
  const auto how = ThreadTeam::current() == nullptr ? solve_alone : solve_together;
  return how(std::move(problem), read_symbols, size);
}

}  // namespace deltamesh
