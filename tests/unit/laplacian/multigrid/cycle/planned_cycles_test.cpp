// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "base/threads/thread_team.h"
#include "laplacian/anchors/anchors.h"
#include "laplacian/operator/delta.h"
#include "laplacian/solver.h"
#include "support/graph_mesh.h"
#include "unit/laplacian/solver_problem.h"

namespace deltamesh {
namespace {

using test::errors;
using test::GraphMesh;
using test::many_sheets;
using test::quantized;
using test::round_to;
using test::SolverProblem;

/// Cycles that leave a solution close to the exact one, also without compensation.
void expect_few_cycles(const SolverProblem& problem, int most) {
  const std::vector<Vec3> exact = solve_directly(problem);
  auto solver = solver_for(problem);
  std::vector<Vec3> x(exact.size());
  const test::Errors of_exact = errors(exact, problem.mesh.positions);
  for (const int cycles : {most, most + 3}) {
    ASSERT_TRUE(solver.solve(problem.anchors, problem.deltas, problem.targets, cycles, x));
    EXPECT_LT(errors(x, exact).rms, 0.2 * of_exact.rms) << cycles;
    EXPECT_LT(errors(x, problem.mesh.positions).rms, 1.02 * of_exact.rms) << cycles;
    EXPECT_LT(errors(x, problem.mesh.positions).largest, 1.05 * of_exact.largest) << cycles;
  }
}

TEST(PlannedCycles, ThreadsMakeNoDifference) {
  GraphMesh parts = many_sheets();
  test::add_sheet(parts, 330, 200, {0, 500, 0});
  for (const SolverProblem& problem :
       {quantized(test::sheet(310, 230), 360, 8), quantized(test::sheet(310, 230), 4000, 8),
        quantized(test::sheet(20, 3300), 70, 8), quantized(test::finish(std::move(parts)), 900, 8),
        quantized(test::fan(70000), 350, 8)}) {
    for (const int cycles : {3, 1}) {
      SCOPED_TRACE(cycles);
      std::vector<Vec3> alone;
      for (const unsigned threads : {1U, 2U, 3U, 8U}) {
        SCOPED_TRACE(threads);
        ThreadTeam team(threads);
        const auto x =
            SingleSolve({problem.mesh.graph, problem.mesh.components, &team}, problem.anchors, cycles)
                .solve(problem.deltas, problem.targets, problem.deltas.size());
        ASSERT_TRUE(x);
        if (alone.empty()) alone.assign(x->begin(), x->end());
        EXPECT_TRUE(std::equal(x->begin(), x->end(), alone.begin(), alone.end()));
      }
    }
  }
}

TEST(PlannedCycles, AreFew) {
  expect_few_cycles(quantized(test::sheet(120, 90), 50, 4), 4);
  expect_few_cycles(quantized(test::sheet(120, 90), 50, 8), 8);
  expect_few_cycles(quantized(test::sheet(120, 90), 5, 8), 16);
  expect_few_cycles(quantized(many_sheets(), 100, 8), 10);
}

TEST(PlannedCycles, AreFewWithManyAnchors) {
  expect_few_cycles(quantized(test::sheet(120, 90), 110, 8), 8);
  expect_few_cycles(quantized(test::sheet(120, 90), 250, 8), 8);
  expect_few_cycles(quantized(many_sheets(), 600, 8), 8);
}

TEST(PlannedCycles, GiveExactDeltasBack) {
  SolverProblem problem = quantized(test::sheet(80, 80), 32, 8);
  problem.deltas = delta_coordinates(problem.mesh.graph, problem.mesh.positions);
  for (std::size_t a = 0; a < problem.anchors.size(); ++a)
    problem.targets[a] = problem.mesh.positions[problem.anchors[a]];
  auto solver = solver_for(problem);
  std::vector<Vec3> x(problem.deltas.size());
  ASSERT_TRUE(solver.solve(problem.anchors, problem.deltas, problem.targets, 32, x));
  EXPECT_LT(errors(x, problem.mesh.positions).largest, 7.6e-6);  // what floats of 80 can tell
}

TEST(PlannedCycles, DoNotDependOnEarlierOnes) {
  const SolverProblem problem = quantized(many_sheets(), 100, 8);
  auto solver = solver_for(problem);
  std::vector<Vec3> x(problem.deltas.size());
  std::vector<Vec3> again(x.size());
  ASSERT_TRUE(solver.solve(problem.anchors, problem.deltas, problem.targets, 2, x));
  ASSERT_TRUE(
      solver.solve(problem.anchors, std::vector<Vec3>(x.size(), Vec3{1, 2, 3}), problem.targets, 5, again));
  ASSERT_TRUE(solver.solve(problem.anchors, problem.deltas, problem.targets, 0, again));
  ASSERT_TRUE(solver.solve(problem.anchors, problem.deltas, problem.targets, 2, again));
  EXPECT_EQ(x, again);
}

/// Of any number of cycles.
TEST(PlannedCycles, ForgetsWhatIsNotFinite) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const std::uint32_t anchors : {100U, 1000U}) {
    const SolverProblem problem = quantized(many_sheets(), anchors, 8);
    for (const int cycles : {0, 1, 4}) {
      SCOPED_TRACE(cycles);
      auto fresh = solver_for(problem);
      auto used = solver_for(problem);
      std::vector<Vec3> x(problem.deltas.size());
      std::vector<Vec3> again(x.size());
      static_cast<void>(used.solve(problem.anchors, std::vector<Vec3>(x.size(), Vec3{kNan, kNan, kNan}),
                                   problem.targets, cycles, again));
      ASSERT_TRUE(fresh.solve(problem.anchors, problem.deltas, problem.targets, cycles, x));
      ASSERT_TRUE(used.solve(problem.anchors, problem.deltas, problem.targets, cycles, again));
      EXPECT_EQ(x, again);
    }
  }
}

/// Steps so small that whole numbers of them take more than 32 bits.
TEST(PlannedCycles, DELT7TellEncodersWhereTheyLeaveTheRange) {
  const SolverProblem problem = quantized(test::sheet(80, 80), 32, 8);
  auto solver = solver_for(problem);
  const SymbolRows symbols(std::vector<std::int32_t>(3 * problem.deltas.size(), 0));
  std::vector<Vec3> x(problem.deltas.size());
  EXPECT_TRUE(
      solver.solve(problem.anchors, DeltaView(symbols.view(), {.step = 1e-6}), problem.targets, 2, x));
  const auto solved =
      solver.solve(problem.anchors, DeltaView(symbols.view(), {.step = 1e-8}), problem.targets, 2, x);
  ASSERT_FALSE(solved);
  EXPECT_STREQ(solved.error().rule, "DELT-7");
}

TEST(PlannedCycles, DELT3DoNotHideWhatIsNotFinite) {
  SolverProblem problem = quantized(many_sheets(), 100, 8);
  problem.targets.front() = {1e300, 0, 0};  // of the first component, finite ones follow
  const auto x = SingleSolve({problem.mesh.graph, problem.mesh.components}, problem.anchors, 3)
                     .solve(problem.deltas, problem.targets, problem.deltas.size());
  ASSERT_TRUE(x);
  EXPECT_FALSE(std::all_of(x->begin(), x->end(), [](const Vec3& v) { return std::isfinite(dot(v, v)); }));
}

}  // namespace
}  // namespace deltamesh
