// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/solver.h"

#include <algorithm>

#include "base/try.h"
#include "laplacian/coarsest/coarsest.h"
#include "laplacian/multigrid/setup/levels.h"
#include "topology/subgraph.h"

namespace deltamesh {
namespace {

bool is_cycled(const ComponentProblem& problem) noexcept {
  return problem.vertices.size() >= multigrid::kFewestNodesToCoarsen;
}

/// Of a component into the whole: in place where its rows follow each other.
template <class Write>
void write_rows(const VertexSubset& vertices, std::span<Vec3> x, std::vector<Vec3>& rows,
                const Write& write) {
  const auto& runs = vertices.runs();
  if (runs.size() == 1) return write(x.subspan(runs.front().begin, runs.front().size()));
  rows.resize(vertices.size());
  write(std::span<Vec3>(rows));
  scatter_rows(std::span<const Vec3>(rows), vertices, x);
}

Result<void> check_range(const multigrid::RangeWatch& watch) {
  if (watch.holds()) return {};
  return Error{.code = ErrorCode::kInvalidStream,
               .message = "planned cycles leave the range of 32 bits",
               .rule = "DELT-7"};
}

}  // namespace

PlannedSetup::PlannedSetup(const SolverGraph& graph, std::span<const std::uint32_t> anchors)
    : graph_(graph),
      anchors_(anchors.begin(), anchors.end()),
      problems_(split_components(graph.components, anchors)) {
  for (const ComponentProblem& problem : problems_) {
    if (!is_cycled(problem)) continue;
    const bool is_whole = problems_.size() == 1;
    Cycled& cycled = cycled_.emplace_back();
    cycled.problem = &problem;
    if (!is_whole) cycled.graph = copy_vertices(graph.graph, problem.vertices);
    cycled.levels =
        multigrid::build_levels(is_whole ? graph.graph : cycled.graph, problem.anchors, graph.team);
    if (cycled.levels.size() > 1) cycled.cycles.emplace(cycled.levels, graph.team);
  }
}

bool PlannedSetup::is_for(std::span<const std::uint32_t> anchors) const noexcept {
  return std::equal(anchors.begin(), anchors.end(), anchors_.begin(), anchors_.end());
}

Result<std::vector<PlannedSetup::Part>> PlannedSetup::run_cycles(const DeltaView& deltas,
                                                                 std::span<const Vec3> targets, int cycles,
                                                                 multigrid::RangeWatch* watch) {
  DELTAMESH_CHECK(check_size());
  std::vector<Part> parts;
  for (Cycled& cycled : cycled_) {
    const ComponentDeltas own(deltas, cycled.problem->vertices);
    parts.push_back({cycled.problem,
                     cycled.cycles->solve(own.view(), cycled.problem->pick_targets(targets), cycles, watch)});
  }
  return parts;
}

Result<void> PlannedSetup::follow_cycles(const DeltaView& deltas, std::span<const Vec3> targets,
                                         multigrid::RangeWatch* watch,
                                         const std::function<bool(std::span<const Part>)>& look) {
  DELTAMESH_CHECK(check_size());
  std::deque<ComponentDeltas> own_deltas;
  std::vector<std::vector<Vec3>> own_targets;
  for (Cycled& cycled : cycled_) {
    own_deltas.emplace_back(deltas, cycled.problem->vertices);
    own_targets.push_back(cycled.problem->pick_targets(targets));
    cycled.cycles->start(own_deltas.back().view(), own_targets.back(), watch);
  }
  std::vector<Part> parts;
  do {
    parts.clear();
    for (std::size_t i = 0; i < cycled_.size(); ++i) {
      cycled_[i].cycles->cycle(own_deltas[i].view(), own_targets[i]);
      parts.push_back({cycled_[i].problem, cycled_[i].cycles->solution_so_far(own_deltas[i].view())});
    }
  } while (look(parts));
  return {};
}

Result<void> PlannedSetup::check_size() const {
  for (const Cycled& cycled : cycled_) {
    if (!cycled.cycles)
      return Error{.code = ErrorCode::kLimitExceeded, .message = "more vertices than can be solved for"};
  }
  return {};
}

void PlannedSetup::write(std::span<const Part> parts, std::span<Vec3> x) const {
  std::vector<Vec3> rows;
  for (const Part& part : parts) {
    write_rows(part.problem->vertices, x, rows,
               [&](std::span<Vec3> own) { part.solution.write(own, graph_.team); });
  }
}

void PlannedSetup::solve_small(const DeltaView& deltas, std::span<const Vec3> targets,
                               std::span<Vec3> x) const {
  std::vector<Vec3> rows;
  multigrid::EnvelopeFactor factor;
  for (const ComponentProblem& problem : problems_) {
    if (is_cycled(problem)) continue;
    const Adjacency graph = copy_vertices(graph_.graph, problem.vertices);
    const multigrid::Level level = multigrid::finest_level(graph, problem.anchors);
    const ComponentDeltas own(deltas, problem.vertices);
    write_rows(problem.vertices, x, rows, [&](std::span<Vec3> solved) {
      multigrid::solve_directly(level, own.view(), problem.pick_targets(targets), factor, solved);
    });
  }
}

Result<void> PlannedSolver::solve(std::span<const std::uint32_t> anchors, const DeltaView& deltas,
                                  std::span<const Vec3> targets, int cycles, std::span<Vec3> x) {
  PlannedSetup& setup = setup_for(anchors);
  multigrid::RangeWatch watch;
  DELTAMESH_TRY(const auto parts, setup.run_cycles(deltas, targets, cycles, &watch));
  setup.write(parts, x);
  setup.solve_small(deltas, targets, x);
  return check_range(watch);
}

Result<void> PlannedSolver::follow(std::span<const std::uint32_t> anchors, const DeltaView& deltas,
                                   std::span<const Vec3> targets, const Look& look) {
  PlannedSetup& setup = setup_for(anchors);
  multigrid::RangeWatch watch;
  std::vector<Vec3> x(deltas.size());
  setup.solve_small(deltas, targets, x);
  int cycles = 0;
  DELTAMESH_CHECK(
      setup.follow_cycles(deltas, targets, &watch, [&](std::span<const PlannedSetup::Part> parts) {
        setup.write(parts, x);
        return watch.holds() && look(++cycles, x);
      }));
  return check_range(watch);
}

PlannedSetup& PlannedSolver::setup_for(std::span<const std::uint32_t> anchors) {
  if (!planned_ || !planned_->is_for(anchors)) {
    planned_.reset();  // before memory is taken for the next one
    planned_.emplace(graph_, anchors);
  }
  return *planned_;
}

Result<LargeVector<Vec3>> SingleSolve::solve(const DeltaView& deltas, std::span<const Vec3> targets,
                                             int cycles, std::size_t size) && {
  DELTAMESH_TRY(const auto parts, setup_.run_cycles(deltas, targets, cycles, nullptr));
  setup_.drop_levels();
  LargeVector<Vec3> x(size);
  const std::span<Vec3> solved = std::span(x).first(deltas.size());
  setup_.write(parts, solved);
  setup_.solve_small(deltas, targets, solved);
  return x;
}

}  // namespace deltamesh
