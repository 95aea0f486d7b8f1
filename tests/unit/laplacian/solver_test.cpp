// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "base/threads/thread_team.h"
#include "direct_solver/direct_solver.h"
#include "highpass/delta_quantizer.h"
#include "laplacian/operator/delta.h"
#include "laplacian/operator/solved_part.h"
#include "support/graph_mesh.h"
#include "topology/subgraph.h"

namespace deltamesh {
namespace {

using test::GraphMesh;

/// Sheets of many depths, and strips; the largest set is neither the first nor the last.
GraphMesh many_sizes() {
  GraphMesh mesh;
  for (std::uint32_t i = 0; i < 30; ++i)
    test::add_sheet(mesh, 3 + 2 * (i % 7) + i, 2 + i % 5, {90.0 * (i % 8), 20.0 * (i / 8), 3});
  test::add_sheet(mesh, 50, 40, {0, 200, 0});
  test::add_sheet(mesh, 100, 9, {100, 200, 0});
  return test::finish(std::move(mesh));
}

/// A decoder solves once, alone or with a team, and has the step and the shifts of a stream.
TEST(SingleSolve, HasTheBitsOfThePlannedSolver) {
  for (const auto& mesh : {test::sheet(90, 70), many_sizes(), test::fan(300), test::sheet(8, 3)}) {
    const std::vector<std::uint32_t> anchors = test::anchors_of(mesh, 60);
    std::vector<Vec3> targets;
    for (const std::uint32_t anchor : anchors) targets.push_back(mesh.positions[anchor]);
    std::vector<Vec3> deltas = delta_coordinates(mesh.graph, mesh.positions);
    std::vector<std::int32_t> planar(3 * deltas.size());
    const DeltaQuantizer quantizer{.step = 1.0 / 64, .shift = {.one = 64, .more = 32}};
    for (std::size_t i = 0; i < deltas.size(); ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto symbol = static_cast<std::int32_t>(std::round(64 * deltas[i][axis]));
        planar[axis * deltas.size() + i] = symbol;
        deltas[i][axis] = quantizer.value(symbol);
      }
    }
    const SymbolRows symbols(planar);
    const DeltaView view(symbols.view(), {.step = 1.0 / 64, .shifts = {0, 0.25, 0.125}});
    std::vector<Vec3> x(mesh.positions.size());
    for (const int cycles : {1, 3}) {
      SCOPED_TRACE(cycles);
      const auto solved =
          PlannedSolver(mesh.graph, mesh.components).solve(anchors, deltas, targets, cycles, x);
      // Around the hub of a fan they leave the range: no encoder plans such.
      if (!solved && std::string_view(solved.error().rule) == "DELT-7") continue;
      ASSERT_TRUE(solved);
      const std::size_t size = x.size() + static_cast<std::size_t>(7 * cycles);
      for (const unsigned threads : {1U, 2U}) {
        ThreadTeam team(threads);
        const auto single =
            SingleSolve({mesh.graph, mesh.components, &team}, anchors).solve(view, targets, cycles, size);
        ASSERT_TRUE(single);
        ASSERT_EQ(single->size(), size);
        EXPECT_TRUE(std::equal(x.begin(), x.end(), single->begin()));
      }
    }
  }
}

/// As around the hub of a fan: encoders do not plan such cycles [DELT-7].
bool leaves_range(const Result<void>& solved) {
  return !solved && std::string_view(solved.error().rule) == "DELT-7";
}

/// An encoder solves many times with one set-up, a decoder once: the solutions must be equal to the last bit.
TEST(PlannedSolver, AnswersDoNotDependOnEarlierOnes) {
  for (const auto& mesh : {test::sheet(90, 70), test::fragments(), test::fan(300)}) {
    const SolvedPart part = extract_solved_part(mesh.graph, mesh.components);
    std::vector<std::uint32_t> anchors;
    for (const std::uint32_t vertex : test::anchors_of(mesh, 12))
      if (const auto row = part.vertices.row_of(vertex)) anchors.push_back(*row);
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
    for (const int cycles : {1, 2}) {
      PlannedSolver solver(part.graph, part.components);
      const auto solved = solver.solve(anchors, coarse, targets, cycles, first);
      if (leaves_range(solved)) continue;
      ASSERT_TRUE(solved);
      ASSERT_TRUE(solver.solve(anchors, fine, targets, cycles, other));
      ASSERT_TRUE(solver.solve(anchors, coarse, targets, cycles, again));
      EXPECT_EQ(first, again);
      EXPECT_NE(first, other);
      PlannedSolver fresh(part.graph, part.components);
      ASSERT_TRUE(fresh.solve(anchors, fine, targets, cycles, again));
      EXPECT_EQ(other, again);
    }
  }
}

TEST(PlannedSolver, FollowsFromCycleToCycleWhatSolvingFinds) {
  for (const auto& mesh : {test::sheet(90, 70), many_sizes(), test::sheet(4, 3)}) {
    const std::vector<std::uint32_t> anchors = test::anchors_of(mesh, 60);
    std::vector<Vec3> targets;
    for (const std::uint32_t anchor : anchors) targets.push_back(mesh.positions[anchor]);
    const std::vector<Vec3> deltas = delta_coordinates(mesh.graph, mesh.positions);
    PlannedSolver solver(mesh.graph, mesh.components);
    std::vector<std::vector<Vec3>> found;
    ASSERT_TRUE(solver.follow(anchors, deltas, targets, [&](int cycles, std::span<const Vec3> x) {
      found.emplace_back(x.begin(), x.end());
      EXPECT_EQ(cycles, static_cast<int>(found.size()));
      return cycles < 4;
    }));
    ASSERT_EQ(found.size(), 4U);
    for (int cycles = 1; cycles <= 4; ++cycles) {
      std::vector<Vec3> x(deltas.size());
      ASSERT_TRUE(solver.solve(anchors, deltas, targets, cycles, x));
      EXPECT_EQ(found[static_cast<std::size_t>(cycles - 1)], x) << cycles;
    }
  }
}

/// Each is what it would be without the others, bit by bit; small ones are least-squares solutions.
TEST(PlannedSolver, DELT4ComponentsAreSolvedByThemselves) {
  const GraphMesh mesh = many_sizes();
  const std::vector<std::uint32_t> anchors = test::anchors_of(mesh, 60);
  std::vector<Vec3> targets;
  for (const std::uint32_t anchor : anchors) targets.push_back(mesh.positions[anchor]);
  const std::vector<Vec3> deltas = delta_coordinates(mesh.graph, mesh.positions);
  std::vector<Vec3> x(deltas.size());
  ASSERT_TRUE(PlannedSolver(mesh.graph, mesh.components).solve(anchors, deltas, targets, 2, x));
  std::vector<Vec3> exact(deltas.size());
  test::DirectSolver(mesh.graph, anchors).solve(deltas, targets, exact);
  std::size_t cycled = 0;
  for (const ComponentProblem& problem : split_components(mesh.components, anchors)) {
    const Adjacency graph = copy_vertices(mesh.graph, problem.vertices);
    const ComponentDeltas own(deltas, problem.vertices);
    std::vector<Vec3> alone(graph.vertex_count());
    ASSERT_TRUE(PlannedSolver(graph, find_components(graph))
                    .solve(problem.anchors, own.view(), problem.pick_targets(targets), 2, alone));
    cycled += alone.size() >= 200 ? 1 : 0;
    for (std::uint32_t row = 0; row < alone.size(); ++row) {
      const std::uint32_t vertex = problem.vertices.vertex(row);
      EXPECT_EQ(alone[row], x[vertex]);
      if (alone.size() < 200) {
        EXPECT_LT(length(x[vertex] - exact[vertex]), 1e-6);
      }
    }
  }
  EXPECT_GE(cycled, 2U);
}

/// Where one of them lies in several runs of vertices.
TEST(SplitComponents, TakesVerticesAndAnchorsOfEach) {
  GraphMesh mesh;
  for (std::uint32_t v = 0; v < 9; ++v) mesh.positions.push_back({1.0 * v, 0, 0});
  mesh.triangles = {0, 1, 5, 2, 3, 4, 5, 6, 8};
  mesh = test::finish(std::move(mesh));
  const std::vector<std::uint32_t> anchors{1, 3, 6, 7};
  const auto problems = split_components(mesh.components, anchors);
  ASSERT_EQ(problems.size(), 3U);
  EXPECT_EQ(problems[0].vertices.size(), 5U);
  EXPECT_EQ(problems[0].anchors, (std::vector<std::uint32_t>{1, 3}));
  EXPECT_EQ(problems[0].numbers, (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(problems[1].anchors, (std::vector<std::uint32_t>{1}));
  EXPECT_EQ(problems[2].numbers, (std::vector<std::uint32_t>{3}));
  const ComponentDeltas picked(mesh.positions, problems[0].vertices);
  ASSERT_EQ(picked.view().size(), 5U);
  EXPECT_EQ(picked.view()[2], mesh.positions[5]);
  EXPECT_EQ(problems[0].pick_targets(mesh.positions),
            (std::vector<Vec3>{mesh.positions[0], mesh.positions[2]}));
  std::vector<std::int32_t> planar(27, 0);
  planar[8] = 70000;
  const SymbolRows symbols(planar);
  const ComponentDeltas of_symbols(DeltaView(symbols.view(), {.step = 2}), problems[0].vertices);
  EXPECT_EQ(of_symbols.view()[4], (Vec3{140000, 0, 0}));
}

}  // namespace
}  // namespace deltamesh
