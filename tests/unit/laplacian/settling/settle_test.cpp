// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "laplacian/operator/delta.h"
#include "laplacian/solver.h"
#include "support/graph_mesh.h"
#include "unit/laplacian/random_problems.h"
#include "unit/laplacian/solver_problem.h"

namespace deltamesh {
namespace {

using test::errors;
using test::GraphMesh;
using test::many_sheets;
using test::quantized;
using test::round_to;
using test::SolverProblem;

TEST(Settle, DELT6IsAsGoodAsTheDirectSolver) {
  for (const int bits : {4, 8}) {
    for (const std::uint32_t anchors : {24U, 60U, 120U}) {
      SCOPED_TRACE(std::to_string(bits) + " bits, " + std::to_string(anchors) + " anchors");
      test::expect_as_good_as_direct(quantized(test::sheet(120, 100), anchors, bits));
    }
  }
}

TEST(Settle, CopesWithManyComponents) {
  test::expect_as_good_as_direct(quantized(many_sheets(), 150, 8));
  test::expect_as_good_as_direct(quantized(test::renumbered(many_sheets()), 150, 8));
}

TEST(Settle, CopesWithOneAnchorToAComponent) {
  test::expect_as_good_as_direct(quantized(many_sheets(), 1, 8));
  test::expect_as_good_as_direct(quantized(test::sheet(100, 100), 1, 8));
}

TEST(Settle, CopesWithStripsAndHubs) {
  test::expect_as_good_as_direct(quantized(test::sheet(2000, 2), 20, 8));
  for (const std::uint32_t anchors : {20U, 200U, 3000U, 6001U}) {
    SCOPED_TRACE(anchors);
    test::expect_as_good_as_direct(quantized(test::fan(6000), anchors, 8));
  }
}

/// Cycles converge slowly there.
TEST(Settle, CopesWithLongStrips) { test::expect_as_good_as_direct(quantized(test::sheet(20000, 2), 3, 8)); }

/// No error is to be expected, so only what floats can show ends the cycles.
TEST(Settle, ZerosGiveTheAnchorsMean) {
  for (const std::uint32_t anchors : {1U, 30U}) {
    SolverProblem problem = quantized(test::sheet(90, 80), anchors, 8);
    problem.deltas.assign(problem.deltas.size(), Vec3{});
    problem.targets.assign(problem.targets.size(), Vec3{3, -4, 5});
    for (const Vec3& x : test::settle(problem)) EXPECT_LT(length(x - Vec3{3, -4, 5}), 1e-5);
    problem.targets.assign(problem.targets.size(), Vec3{});
    for (const Vec3& x : test::settle(problem)) EXPECT_EQ(length(x), 0);
  }
}

/// Half of the sheet, or every other vertex of that half, and one far away.
TEST(Settle, CopesWithAnchorsInOnePlace) {
  for (const std::uint32_t stride : {1U, 2U}) {
    SolverProblem problem = quantized(test::sheet(100, 100), 1, 8);
    problem.anchors.clear();
    problem.targets.clear();
    for (std::uint32_t v = 0; v < 5000; v += stride) problem.anchors.push_back(v);
    problem.anchors.push_back(9999);
    for (const std::uint32_t anchor : problem.anchors)
      problem.targets.push_back(round_to(problem.mesh.positions[anchor], 0.01));
    test::expect_as_good_as_direct(problem);
  }
}

/// The square of a hub's degree would be more entries than 32 bits can count.
TEST(Settle, CopesWithHugeHubsAsAnchors) {
  test::expect_as_good_as_direct(quantized(test::fan(70000), 70001, 8));
}

TEST(Settle, CopesWithHugeHubsAndFewAnchors) {
  test::expect_as_good_as_direct(quantized(test::fan(300000), 1500, 8));
}

TEST(Settle, CopesWithAnchorsEverywhere) {
  test::expect_as_good_as_direct(quantized(test::sheet(40, 40), 1600, 8));
  test::expect_as_good_as_direct(quantized(test::sheet(40, 40), 700, 8));
}

TEST(Settle, ExactDeltasGiveThePositionsBack) {
  SolverProblem problem = quantized(test::sheet(80, 80), 32, 8);
  problem.step = 0;
  problem.deltas = delta_coordinates(problem.mesh.graph, problem.mesh.positions);
  for (std::size_t a = 0; a < problem.anchors.size(); ++a)
    problem.targets[a] = problem.mesh.positions[problem.anchors[a]];
  EXPECT_LT(errors(test::settle(problem), problem.mesh.positions).largest, 1e-5);
}

void expect_nearly_exact(std::uint32_t seed, std::uint32_t vertices) {
  SCOPED_TRACE("seed " + std::to_string(seed) + ", " + std::to_string(vertices) + " vertices");
  const SolverProblem problem = test::RandomProblems(seed, vertices).make();
  const std::vector<Vec3> exact = test::solve_directly(problem);
  EXPECT_LE(errors(test::settle(problem), exact).rms, 0.25 * errors(exact, problem.mesh.positions).rms);
}

TEST(Settle, DELT6CopesWithRandomProblems) {
  for (std::uint32_t seed = 1; seed <= 80; ++seed) expect_nearly_exact(seed, 1000);
  for (std::uint32_t seed = 81; seed <= 110; ++seed) expect_nearly_exact(seed, 3000);
  for (const std::uint32_t seed : {34U, 72U, 162U, 273U}) expect_nearly_exact(seed, 8000);
}

/// Between few anchors in a large mesh.
TEST(Settle, DELT6CopesWithLargeRandomProblems) {
  for (const std::uint32_t seed : {2001U, 2014U, 2032U}) expect_nearly_exact(seed, 40000);
}

TEST(Settle, EqualProblemsGiveEqualBits) {
  const SolverProblem problem = quantized(many_sheets(), 100, 8);
  const std::vector<Vec3> x = test::settle(problem);
  auto solver = test::solver_for(problem);
  std::vector<Vec3> again(x.size());
  ASSERT_TRUE(
      solver.solve(problem.anchors, std::vector<Vec3>(x.size(), Vec3{1, 2, 3}), problem.targets, 0, again));
  ASSERT_TRUE(solver.solve(problem.anchors, problem.deltas, problem.targets, 0, again));
  EXPECT_EQ(x, again);
}

}  // namespace
}  // namespace deltamesh
