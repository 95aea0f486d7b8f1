// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/part_solver.h"

#include <gtest/gtest.h>

#include <string_view>

#include "base/thread_team.h"
#include "geometry/delta_quantizer.h"
#include "geometry/highpass.h"
#include "laplacian/anchors/anchors.h"
#include "laplacian/multigrid/setup/levels.h"
#include "laplacian/operator/delta.h"
#include "laplacian/solve_once.h"
#include "laplacian/solver.h"
#include "support/graph_mesh.h"

namespace deltamesh {
namespace {

using test::GraphMesh;

/// Without them there are no planned cycles [DELT-7].
bool has_levels(const Adjacency& graph, const std::vector<std::uint32_t>& anchors) {
  return multigrid::build_levels(graph, anchors).size() > 1;
}

/// As around the hub of a fan: encoders do not plan such cycles [DELT-7].
bool leaves_range(const Result<void>& solved) {
  return !solved && std::string_view(solved.error().rule) == "DELT-7";
}

/// A decoder solves once, an encoder many times with one set-up: the answers must be the same to the last
/// bit.
TEST(PartSolver, AnswersDoNotDependOnEarlierOnes) {
  for (const auto& mesh : {test::sheet(90, 70), test::fragments(), test::fan(300)}) {
    const SolvedPart part = extract_solved_part(mesh.graph, mesh.components);
    std::vector<std::uint32_t> anchors;
    for (const std::uint32_t vertex : place_anchors(mesh.graph, mesh.components, {.count = 12}).vertices)
      if (const auto row = part.row_of(vertex)) anchors.push_back(*row);
    std::vector<Vec3> positions;
    for (std::size_t row = 0; row < part.row_count; ++row)
      positions.push_back(mesh.positions[part.vertex(row)]);
    std::vector<Vec3> targets;
    for (const std::uint32_t anchor : anchors) targets.push_back(positions[anchor]);
    const std::vector<Vec3> fine = delta_coordinates(part.graph, positions);
    std::vector<Vec3> coarse = fine;
    for (Vec3& delta : coarse)
      for (double& x : delta) x = std::round(4 * x) / 4;

    std::vector<Vec3> first(positions.size());
    std::vector<Vec3> other(positions.size());
    std::vector<Vec3> again(positions.size());
    for (const int cycles : {0, 2}) {
      if (cycles > 0 && !has_levels(part.graph, anchors)) continue;
      PartSolver solver(part);
      const auto solved = solver.solve(anchors, coarse, targets, cycles, first);
      if (leaves_range(solved)) continue;
      ASSERT_TRUE(solved);
      ASSERT_TRUE(solver.solve(anchors, fine, targets, cycles, other));
      ASSERT_TRUE(solver.solve(anchors, coarse, targets, cycles, again));
      EXPECT_EQ(first, again);
      EXPECT_NE(first, other);
      PartSolver fresh(part);
      ASSERT_TRUE(fresh.solve(anchors, fine, targets, cycles, again));
      EXPECT_EQ(other, again);
    }
  }
}

/// Sheets of many depths, and strips; the largest set is neither the first nor the last.
GraphMesh many_sizes() {
  GraphMesh mesh;
  for (std::uint32_t i = 0; i < 30; ++i)
    test::add_sheet(mesh, 3 + 2 * (i % 7) + i, 2 + i % 5, {90.0 * (i % 8), 20.0 * (i / 8), 3});
  test::add_sheet(mesh, 50, 40, {0, 200, 0});
  test::add_sheet(mesh, 100, 9, {100, 200, 0});
  return test::finish(std::move(mesh));
}

/// Alone or with a team.
TEST(SolveOnce, GivesTheSolversBits) {
  for (const auto& mesh : {test::sheet(90, 70), many_sizes(), test::fan(300), test::sheet(8, 3)}) {
    LeastSquaresProblem problem{.graph = mesh.graph, .components = mesh.components};
    problem.anchors = place_anchors(mesh.graph, mesh.components, {.count = 60}).vertices;
    for (const std::uint32_t anchor : problem.anchors) problem.targets.push_back(mesh.positions[anchor]);
    problem.scale = {.step = 1.0 / 64, .shifts = {0, 0.25, 0.125}};
    std::vector<Vec3> deltas = delta_coordinates(mesh.graph, mesh.positions);
    std::vector<std::int32_t> symbols(3 * deltas.size());
    const DeltaQuantizer quantizer{.step = 1.0 / 64, .shift = {.one = 64, .more = 32}};
    for (std::size_t i = 0; i < deltas.size(); ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto symbol = static_cast<std::int32_t>(std::round(64 * deltas[i][axis]));
        symbols[axis * deltas.size() + i] = symbol;
        deltas[i][axis] = quantizer.value(symbol);
      }
    }
    const auto read_symbols = [&](const Adjacency& graph) -> Result<SymbolRows> {
      EXPECT_EQ(graph.neighbors, mesh.graph.neighbors);
      return SymbolRows(symbols);
    };
    const auto solver = make_multigrid_solver(problem.graph, problem.anchors);
    ASSERT_TRUE(solver);
    std::vector<Vec3> x(mesh.positions.size());
    for (const int cycles : {0, 1, 3}) {
      if (cycles > 0 && !has_levels(problem.graph, problem.anchors)) continue;
      const auto solved = (*solver)->solve(deltas, problem.targets, cycles, x);
      if (leaves_range(solved)) continue;
      ASSERT_TRUE(solved);
      problem.cycles = cycles;
      const std::size_t size = x.size() + static_cast<std::size_t>(7 * cycles);
      const auto expect_same = [&](ThreadTeam* team) {
        const auto once = solve_once(problem, read_symbols, size, team);
        ASSERT_TRUE(once);
        ASSERT_EQ(once->size(), size);
        EXPECT_TRUE(std::equal(x.begin(), x.end(), once->begin()));
      };
      expect_same(nullptr);
      ThreadTeam team(2);
      expect_same(&team);
    }
  }
}

TEST(HighpassCoder, SettingsDoNotDependOnEarlierOnes) {
  const auto mesh = test::sheet(80, 60);
  AnchorSequence anchors(mesh.graph, mesh.components);
  HighpassCoder coder(mesh.graph, mesh.components, anchors, mesh.positions, mesh.box);
  const HighpassSettings settings{
      .step = 0.1, .rate_weight = 0.12, .centroids = true, .diffusion = 0.8, .anchors = 20};
  ASSERT_TRUE(coder.code({.step = 0.01, .anchors = 20}));
  const auto coded = coder.code(settings);
  ASSERT_TRUE(coded);
  EXPECT_NE(coded->parameters.shift, ReconstructionShift{});
  const auto read =
      read_highpass(coded->deltas, coded->anchors, mesh.graph, mesh.components, mesh.box, coded->parameters);
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, coded->positions);
  const auto bytes_alone = coder.code_only(settings);
  ASSERT_TRUE(bytes_alone);
  EXPECT_EQ(bytes_alone->deltas, coded->deltas);
  EXPECT_EQ(bytes_alone->anchors, coded->anchors);
}

}  // namespace
}  // namespace deltamesh
