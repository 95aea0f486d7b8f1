// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/thread_team.h"
#include "laplacian/anchors.h"
#include "laplacian/delta.h"
#include "laplacian/multigrid_aggregate.h"
#include "laplacian/multigrid_chunks.h"
#include "laplacian/multigrid_edges.h"
#include "laplacian/multigrid_groups.h"
#include "laplacian/multigrid_hierarchy.h"
#include "laplacian/multigrid_make_interpolation.h"
#include "laplacian/multigrid_parted_order.h"
#include "laplacian/multigrid_smoother.h"
#include "laplacian/multigrid_sweeps.h"
#include "laplacian/small_components.h"
#include "laplacian/solver.h"
#include "support/graph_mesh.h"

namespace deltamesh {
namespace {

using test::GraphMesh;

struct Problem {
  GraphMesh mesh;
  std::vector<std::uint32_t> anchors;
  std::vector<Vec3> deltas;
  std::vector<Vec3> targets;
};

Vec3 round_to(const Vec3& v, double step) {
  return {step * std::round(v[0] / step), step * std::round(v[1] / step), step * std::round(v[2] / step)};
}

/// Quantised as a stream of `bits` is.
Problem quantized(GraphMesh mesh, std::uint32_t anchors, int bits) {
  Problem problem{std::move(mesh), {}, {}, {}};
  const GraphMesh& m = problem.mesh;
  problem.anchors = place_anchors(m.graph, m.components, {.count = anchors}).vertices;
  problem.deltas = delta_coordinates(m.graph, m.positions);
  const double step = std::ldexp(delta_range(problem.deltas), -bits);
  for (Vec3& delta : problem.deltas) delta = round_to(delta, step);
  for (const std::uint32_t anchor : problem.anchors)
    problem.targets.push_back(round_to(m.positions[anchor], m.box.longest_side() / 4095));
  return problem;
}

std::vector<Vec3> solve(const Problem& problem, Result<std::unique_ptr<LeastSquaresSolver>> solver) {
  std::vector<Vec3> x(problem.mesh.positions.size());
  EXPECT_TRUE(solver);
  if (solver) {
    EXPECT_TRUE((*solver)->solve(problem.deltas, problem.targets, x));
  }
  return x;
}

std::vector<Vec3> solve_multigrid(const Problem& problem) {
  return solve(problem, make_multigrid_solver(problem.mesh.graph, problem.anchors));
}

struct Errors {
  double rms = 0;
  double largest = 0;
};

Errors errors(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  Errors result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec3 difference = a[i] - b[i];
    result.rms += dot(difference, difference) / static_cast<double>(a.size());
    result.largest = std::max(result.largest, length(difference));
  }
  result.rms = std::sqrt(result.rms);
  return result;
}

void expect_as_good_as_direct(const Problem& problem) {
  const std::vector<Vec3> x = solve_multigrid(problem);
  const std::vector<Vec3> exact = solve(problem, make_direct_solver(problem.mesh.graph, problem.anchors));
  const Errors ours = errors(x, problem.mesh.positions);
  const Errors best = errors(exact, problem.mesh.positions);
  EXPECT_LE(errors(x, exact).rms, 0.25 * ours.rms) << "[DELT-6]";
  EXPECT_LE(ours.rms, 1.02 * best.rms);
  EXPECT_LE(ours.largest, 1.05 * best.largest);
}

GraphMesh many_sheets() {
  GraphMesh mesh;
  test::add_sheet(mesh, 90, 80, {});
  for (std::uint32_t i = 0; i < 60; ++i)
    test::add_sheet(mesh, 4 + i % 17, 2 + i / 4, {100.0 + 25 * (i % 8), 20.0 * (i / 8), 3});
  return test::finish(std::move(mesh));
}

TEST(Multigrid, DELT6IsAsGoodAsTheDirectSolver) {
  for (const int bits : {4, 8}) {
    for (const std::uint32_t anchors : {24U, 60U, 120U}) {
      SCOPED_TRACE(std::to_string(bits) + " bits, " + std::to_string(anchors) + " anchors");
      expect_as_good_as_direct(quantized(test::sheet(120, 100), anchors, bits));
    }
  }
}

TEST(Multigrid, CopesWithManyComponents) { expect_as_good_as_direct(quantized(many_sheets(), 150, 8)); }

TEST(Multigrid, CopesWithOneAnchorToAComponent) {
  expect_as_good_as_direct(quantized(many_sheets(), 1, 8));
  expect_as_good_as_direct(quantized(test::sheet(100, 100), 1, 8));
}

TEST(Multigrid, CopesWithStripsAndHubs) {
  expect_as_good_as_direct(quantized(test::sheet(2000, 2), 20, 8));
  for (const std::uint32_t anchors : {20U, 200U, 3000U, 6001U}) {
    SCOPED_TRACE(anchors);
    expect_as_good_as_direct(quantized(test::fan(6000), anchors, 8));
  }
}

/// Cycles converge slowly there; every component is larger than what is factored straight away.
TEST(Multigrid, CopesWithLongStrips) { expect_as_good_as_direct(quantized(test::sheet(20000, 2), 3, 8)); }

/// No error is to be expected, so only what floats can show ends the cycles.
TEST(Multigrid, ZerosGiveTheAnchorsMean) {
  for (const std::uint32_t anchors : {1U, 30U}) {
    Problem problem = quantized(test::sheet(90, 80), anchors, 8);
    problem.deltas.assign(problem.deltas.size(), Vec3{});
    problem.targets.assign(problem.targets.size(), Vec3{3, -4, 5});
    for (const Vec3& x : solve_multigrid(problem)) EXPECT_LT(length(x - Vec3{3, -4, 5}), 1e-5);
    problem.targets.assign(problem.targets.size(), Vec3{});
    for (const Vec3& x : solve_multigrid(problem)) EXPECT_EQ(length(x), 0);
  }
}

/// Half of the sheet, or every other vertex of that half, and one far away.
TEST(Multigrid, CopesWithAnchorsInOnePlace) {
  for (const std::uint32_t stride : {1U, 2U}) {
    Problem problem = quantized(test::sheet(100, 100), 1, 8);
    problem.anchors.clear();
    problem.targets.clear();
    for (std::uint32_t v = 0; v < 5000; v += stride) problem.anchors.push_back(v);
    problem.anchors.push_back(9999);
    for (const std::uint32_t anchor : problem.anchors)
      problem.targets.push_back(round_to(problem.mesh.positions[anchor], 0.01));
    expect_as_good_as_direct(problem);
  }
}

/// The square of a hub's degree would be more entries than 32 bits can count.
TEST(Multigrid, CopesWithHugeHubsAsAnchors) {
  expect_as_good_as_direct(quantized(test::fan(70000), 70001, 8));
}

TEST(Multigrid, CopesWithHugeHubsAndFewAnchors) {
  expect_as_good_as_direct(quantized(test::fan(300000), 1500, 8));
}

TEST(Multigrid, CopesWithAnchorsEverywhere) {
  expect_as_good_as_direct(quantized(test::sheet(40, 40), 1600, 8));
  expect_as_good_as_direct(quantized(test::sheet(40, 40), 700, 8));
}

TEST(Multigrid, ExactDeltasGiveThePositionsBack) {
  Problem problem = quantized(test::sheet(80, 80), 32, 8);
  problem.deltas = delta_coordinates(problem.mesh.graph, problem.mesh.positions);
  for (std::size_t a = 0; a < problem.anchors.size(); ++a)
    problem.targets[a] = problem.mesh.positions[problem.anchors[a]];
  EXPECT_LT(errors(solve_multigrid(problem), problem.mesh.positions).largest, 1e-5);
}

TEST(Multigrid, EqualProblemsGiveEqualBits) {
  const Problem problem = quantized(many_sheets(), 100, 8);
  const std::vector<Vec3> x = solve_multigrid(problem);
  auto solver = make_multigrid_solver(problem.mesh.graph, problem.anchors);
  ASSERT_TRUE(solver);
  std::vector<Vec3> again(x.size());
  ASSERT_TRUE((*solver)->solve(std::vector<Vec3>(x.size(), Vec3{1, 2, 3}), problem.targets, again));
  ASSERT_TRUE((*solver)->solve(problem.deltas, problem.targets, again));
  EXPECT_EQ(x, again);
}

/// Of 65,536 vertices on there are several chunks.
TEST(Multigrid, ThreadsMakeNoDifference) {
  GraphMesh parts = many_sheets();
  test::add_sheet(parts, 330, 200, {0, 500, 0});
  for (const Problem& problem :
       {quantized(test::sheet(310, 230), 360, 8), quantized(test::sheet(310, 230), 4000, 8),
        quantized(test::sheet(20, 3300), 70, 8), quantized(test::finish(std::move(parts)), 900, 8),
        quantized(test::fan(70000), 350, 8)}) {
    for (const int cycles : {3, 0}) {
      SCOPED_TRACE(cycles);
      std::vector<Vec3> alone;
      for (const unsigned threads : {1U, 2U, 3U, 8U}) {
        SCOPED_TRACE(threads);
        const ThreadTeam team(threads);
        const auto solver = make_multigrid_solver(problem.mesh.graph, problem.anchors);
        ASSERT_TRUE(solver);
        std::vector<Vec3> x(problem.deltas.size());
        ASSERT_TRUE((*solver)->solve(problem.deltas, problem.targets, cycles, x));
        if (alone.empty()) alone = x;
        EXPECT_EQ(x, alone);
      }
    }
  }
}

/// The second level of a sheet, with chunks that it is too small for.
std::vector<multigrid::Level> levels_with_chunks() {
  const GraphMesh mesh = test::sheet(60, 50);
  const auto anchors = place_anchors(mesh.graph, mesh.components, {.count = 8}).vertices;
  auto levels = multigrid::build_hierarchy(mesh.graph, anchors, 2, multigrid::Coarsening::kQuick);
  multigrid::Level& level = levels.at(1);
  const std::uint32_t n = level.node_count();
  const std::uint32_t coarse = levels.at(2).node_count();
  level.chunks = multigrid::make_chunks(level, {0, n / 4, n / 2, n}, {0, coarse / 4, coarse / 2, coarse});
  levels.erase(levels.begin());
  return levels;
}

TEST(Chunks, HaveNoNeighborsButOnTheRim) {
  const auto levels = levels_with_chunks();
  const multigrid::Level& level = levels[0];
  const multigrid::Chunks& chunks = level.chunks;
  EXPECT_GT(chunks.rim.size(), 0U);
  EXPECT_LT(chunks.rim.size(), level.node_count() / 2);
  const auto chunk_of = [&](std::uint32_t node) {
    return std::upper_bound(chunks.bounds.begin(), chunks.bounds.end(), node) - chunks.bounds.begin();
  };
  std::vector<std::uint32_t> inner, outer;
  chunks.visit([&](std::uint32_t i) { inner.push_back(i); }, [&](std::uint32_t i) { outer.push_back(i); });
  EXPECT_EQ(outer, chunks.rim);
  EXPECT_EQ(inner.size() + outer.size(), level.node_count());
  EXPECT_TRUE(std::is_sorted(inner.begin(), inner.end()));
  for (const std::uint32_t i : inner) {
    EXPECT_FALSE(chunks.is_on_rim[i]);
    for (std::uint32_t e = level.offsets[i]; e < level.offsets[i + 1]; ++e)
      EXPECT_TRUE(chunk_of(level.neighbors[e]) == chunk_of(i) || chunks.is_on_rim[level.neighbors[e]]);
  }
}

/// Nodes of a part and their neighbours.
std::set<std::uint32_t> reach_of(const multigrid::Level& level, const multigrid::PartedOrder& order,
                                 std::uint32_t part) {
  std::set<std::uint32_t> reach;
  for (std::uint32_t k = order.begin(part); k < order.end(part); ++k) {
    const std::uint32_t node = order.nodes[k];
    reach.insert(node);
    reach.insert(level.neighbors.begin() + level.offsets[node],
                 level.neighbors.begin() + level.offsets[node + 1]);
  }
  return reach;
}

/// [DELT-7]: by number the first half, the others that are further than two edges away, the rest.
void expect_parts(const multigrid::Level& level) {
  const multigrid::PartedOrder order = multigrid::order_in_parts(level);
  ASSERT_EQ(order.size(), level.node_count());
  ASSERT_EQ(order.parts(), 2U);
  EXPECT_EQ(order.second, level.node_count() / 2);
  for (std::uint32_t k = 0; k < order.second; ++k) ASSERT_EQ(order.nodes[k], k);
  EXPECT_TRUE(std::is_sorted(order.nodes.begin() + order.second, order.nodes.begin() + order.rest));
  EXPECT_TRUE(std::is_sorted(order.nodes.begin() + order.rest, order.nodes.end()));
  EXPECT_GT(order.rest, order.second);
  EXPECT_LT(order.rest, order.size());
  std::vector<std::uint32_t> all = order.nodes;
  std::sort(all.begin(), all.end());
  for (std::uint32_t i = 0; i < all.size(); ++i) ASSERT_EQ(all[i], i);
  const std::set<std::uint32_t> first = reach_of(level, order, 0), second = reach_of(level, order, 1);
  for (const std::uint32_t node : second) EXPECT_EQ(first.count(node), 0U) << node;
  for (std::uint32_t k = order.rest; k < order.size(); ++k) {
    const std::uint32_t node = order.nodes[k];
    bool is_close = first.count(node) > 0;
    for (std::uint32_t e = level.offsets[node]; e < level.offsets[node + 1]; ++e)
      is_close |= first.count(level.neighbors[e]) > 0;
    EXPECT_TRUE(is_close) << node;
  }
}

TEST(PartedOrder, PartsHaveNoNodeInReachOfBoth) {
  const auto levels_of = [](const GraphMesh& mesh, std::uint32_t depth) {
    const auto anchors = place_anchors(mesh.graph, mesh.components, {.count = 8}).vertices;
    return multigrid::build_hierarchy(mesh.graph, anchors, depth, multigrid::Coarsening::kQuick);
  };
  const GraphMesh even = test::sheet(64, 32), odd = test::sheet(3, 683), large = test::sheet(200, 90);
  expect_parts(levels_of(even, 0).at(0));
  expect_parts(levels_of(odd, 0).at(0));
  expect_parts(levels_of(large, 1).at(1));
  const GraphMesh small = test::sheet(89, 23);
  const multigrid::PartedOrder order = multigrid::order_in_parts(levels_of(small, 0).at(0));
  EXPECT_EQ(order.parts(), 0U);
  EXPECT_EQ(order.rest, 0U);
  EXPECT_TRUE(std::is_sorted(order.nodes.begin(), order.nodes.end()));
}

multigrid::Float4 some_value(std::uint32_t i) {
  const auto x = static_cast<float>(i % 17) - 8;
  return multigrid::Float4{x, 1 - 0.5F * x, static_cast<float>(i % 5), 0};
}

void expect_near(multigrid::Float4 a, multigrid::Float4 b) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], 2e-4);
}

TEST(Chunks, SweepsKnowWhatTheyLeave) {
  const auto levels = levels_with_chunks();
  const multigrid::Level& level = levels[0];
  const multigrid::Edges edges(level);
  using Values = std::vector<multigrid::Float4>;
  Values step(level.node_count()), total(step.size()), left(step.size());
  const auto keep = [&](std::uint32_t i, multigrid::Float4 value) { total[i] += value; };
  constexpr std::array kSweeps = {1.5F, 1.0F, 1.2F};
  multigrid::sweep(
      level, edges, kSweeps,
      [&](std::uint32_t i, const auto&) { return edges.add_lower(i, step.data(), some_value(i)); },
      [&](std::uint32_t i, const auto&) { return edges.add_all(i, step.data(), some_value(i)); }, step, keep);
  multigrid::take_residuals(level, edges, kSweeps.back(), step,
                            [&](std::uint32_t i, multigrid::Float4 value) { left[i] += value; });
  for (std::uint32_t i = 0; i < step.size(); ++i)
    expect_near(left[i], edges.add_all(i, total.data(), some_value(i)) - level.degree[i] * total[i]);
}

TEST(Chunks, BothFieldsKnowWhatASweepLeaves) {
  const auto levels = levels_with_chunks();
  const multigrid::Level& level = levels[0];
  std::vector<multigrid::Row> b(level.node_count()), u(b.size());
  for (std::uint32_t i = 0; i < b.size(); ++i) b[i] = {some_value(i), 0.01F * some_value(i + 3)};
  std::vector<multigrid::Row> quick(levels[1].node_count()), plain(quick.size());
  multigrid::smooth_from_zero(level, b, u);
  multigrid::restrict_residual_from_zero(level, b, u, quick);
  multigrid::restrict_residual(level, b, u, plain);
  for (std::size_t c = 0; c < quick.size(); ++c) {
    expect_near(quick[c].x, plain[c].x);
    expect_near(quick[c].s, plain[c].s);
  }
}

/// Cycles that leave a solution close to the exact one, also without compensation.
void expect_few_cycles(const Problem& problem, int most) {
  const std::vector<Vec3> exact = solve(problem, make_direct_solver(problem.mesh.graph, problem.anchors));
  const auto solver = make_multigrid_solver(problem.mesh.graph, problem.anchors);
  ASSERT_TRUE(solver);
  std::vector<Vec3> x(exact.size());
  const Errors of_exact = errors(exact, problem.mesh.positions);
  for (const int cycles : {most, most + 3}) {
    ASSERT_TRUE((*solver)->solve(problem.deltas, problem.targets, cycles, x));
    EXPECT_LT(errors(x, exact).rms, 0.2 * of_exact.rms) << cycles;
    EXPECT_LT(errors(x, problem.mesh.positions).rms, 1.02 * of_exact.rms) << cycles;
    EXPECT_LT(errors(x, problem.mesh.positions).largest, 1.05 * of_exact.largest) << cycles;
  }
}

TEST(Multigrid, ChunksMakeNoDifferenceToSpeakOf) {
  expect_few_cycles(quantized(test::sheet(1310, 51), 360, 8), 6);
}

TEST(Multigrid, PlannedCyclesAreFew) {
  expect_few_cycles(quantized(test::sheet(120, 90), 50, 4), 4);
  expect_few_cycles(quantized(test::sheet(120, 90), 50, 8), 8);
  expect_few_cycles(quantized(test::sheet(120, 90), 5, 8), 16);
  expect_few_cycles(quantized(many_sheets(), 100, 8), 10);
}

/// Where anchors are a large share of the third level, the residual field is too rough for it.
TEST(Multigrid, PlannedCyclesAreFewWithManyAnchors) {
  expect_few_cycles(quantized(test::sheet(120, 90), 110, 8), 8);
  expect_few_cycles(quantized(test::sheet(120, 90), 250, 8), 8);
  expect_few_cycles(quantized(many_sheets(), 600, 8), 8);
}

TEST(Multigrid, PlannedCyclesGiveExactDeltasBack) {
  Problem problem = quantized(test::sheet(80, 80), 32, 8);
  problem.deltas = delta_coordinates(problem.mesh.graph, problem.mesh.positions);
  for (std::size_t a = 0; a < problem.anchors.size(); ++a)
    problem.targets[a] = problem.mesh.positions[problem.anchors[a]];
  const auto solver = make_multigrid_solver(problem.mesh.graph, problem.anchors);
  ASSERT_TRUE(solver);
  std::vector<Vec3> x(problem.deltas.size());
  ASSERT_TRUE((*solver)->solve(problem.deltas, problem.targets, 32, x));
  EXPECT_LT(errors(x, problem.mesh.positions).largest, 7.6e-6);  // what floats of 80 can tell
}

TEST(Multigrid, PlannedCyclesDoNotDependOnEarlierOnes) {
  const Problem problem = quantized(many_sheets(), 100, 8);
  const auto solver = make_multigrid_solver(problem.mesh.graph, problem.anchors);
  ASSERT_TRUE(solver);
  std::vector<Vec3> x(problem.deltas.size());
  std::vector<Vec3> again(x.size());
  ASSERT_TRUE((*solver)->solve(problem.deltas, problem.targets, 2, x));
  ASSERT_TRUE((*solver)->solve(std::vector<Vec3>(x.size(), Vec3{1, 2, 3}), problem.targets, 5, again));
  ASSERT_TRUE((*solver)->solve(problem.deltas, problem.targets, 0, again));
  ASSERT_TRUE((*solver)->solve(problem.deltas, problem.targets, 2, again));
  EXPECT_EQ(x, again);
}

/// Of any number of cycles, and with coarsest levels that are factored and others.
TEST(Multigrid, ForgetsWhatIsNotFinite) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const std::uint32_t anchors : {100U, 1000U}) {
    const Problem problem = quantized(many_sheets(), anchors, 8);
    for (const int cycles : {0, 1, 4}) {
      SCOPED_TRACE(cycles);
      const auto fresh = make_multigrid_solver(problem.mesh.graph, problem.anchors);
      const auto used = make_multigrid_solver(problem.mesh.graph, problem.anchors);
      ASSERT_TRUE(fresh);
      ASSERT_TRUE(used);
      std::vector<Vec3> x(problem.deltas.size());
      std::vector<Vec3> again(x.size());
      static_cast<void>((*used)->solve(std::vector<Vec3>(x.size(), Vec3{kNan, kNan, kNan}), problem.targets,
                                       cycles, again));
      ASSERT_TRUE((*fresh)->solve(problem.deltas, problem.targets, cycles, x));
      ASSERT_TRUE((*used)->solve(problem.deltas, problem.targets, cycles, again));
      EXPECT_EQ(x, again);
    }
  }
}

TEST(Multigrid, DELT3PlannedCyclesDoNotHideWhatIsNotFinite) {
  Problem problem = quantized(many_sheets(), 100, 8);
  const auto solver = make_multigrid_solver(problem.mesh.graph, problem.anchors);
  ASSERT_TRUE(solver);
  problem.targets.front() = {1e300, 0, 0};  // of the first component, finite ones follow
  std::vector<Vec3> x(problem.deltas.size());
  ASSERT_TRUE((*solver)->solve(problem.deltas, problem.targets, 3, x));
  EXPECT_FALSE(std::all_of(x.begin(), x.end(), [](const Vec3& v) { return std::isfinite(dot(v, v)); }));
}

TEST(Multigrid, BridgesKeepConstantsAndSymmetry) {
  const GraphMesh mesh = test::sheet(60, 60);
  const auto anchors = place_anchors(mesh.graph, mesh.components, {.count = 20}).vertices;
  const auto levels = multigrid::build_hierarchy(mesh.graph, anchors, 2, multigrid::Coarsening::kQuick);
  ASSERT_EQ(levels.size(), 3U);
  const multigrid::Level& level = levels[1];
  std::set<std::tuple<std::uint32_t, std::uint32_t, float>> edges;
  for (std::uint32_t c = 0; c < level.node_count(); ++c) {
    float degree = 0;
    for (std::uint32_t e = level.offsets[c]; e < level.offsets[c + 1]; ++e) {
      if (level.weights[e] == 0) {  // padding
        EXPECT_NE(e, level.offsets[c]);
        EXPECT_NE(e, level.middle[c]);
        EXPECT_EQ(level.neighbors[e], level.neighbors[e - 1]);
        continue;
      }
      EXPECT_GT(level.weights[e], 0);
      EXPECT_EQ(level.neighbors[e] < c, e < level.middle[c]);
      EXPECT_TRUE(edges.emplace(c, level.neighbors[e], level.weights[e]).second);
      degree += level.weights[e];
    }
    EXPECT_EQ(degree, level.degree[c]);
    EXPECT_EQ((level.middle[c] - level.offsets[c]) % multigrid::kEdgesAtOnce, 0U);
    EXPECT_EQ(level.offsets[c] % multigrid::kEdgesAtOnce, 0U);
  }
  EXPECT_EQ(edges.size(), level.edge_ends);
  for (const auto& [from, to, weight] : edges) EXPECT_TRUE(edges.contains({to, from, weight}));
}

TEST(Multigrid, LevelsShrinkAndKeepTheirAnchorsApart) {
  const GraphMesh mesh = test::sheet(60, 60);
  const auto anchors = place_anchors(mesh.graph, mesh.components, {.count = 20}).vertices;
  const auto levels = multigrid::build_hierarchy(mesh.graph, anchors, 3, multigrid::Coarsening::kExact);
  ASSERT_EQ(levels.size(), 4U);
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const multigrid::Level& level = levels[l];
    EXPECT_EQ(std::set<std::uint32_t>(level.anchors.begin(), level.anchors.end()).size(), anchors.size());
    if (l + 1 == levels.size()) break;
    EXPECT_LT(levels[l + 1].node_count() * 2, level.node_count());
    for (const multigrid::Interpolation& p : level.interpolation) {
      EXPECT_EQ(p.weight(0) + p.weight(1) + p.weight(2), 1);
      for (const std::uint32_t node : {p.node(0), p.node(1), p.node(2)})
        EXPECT_LT(node, levels[l + 1].node_count());
    }
    for (std::size_t a = 0; a < anchors.size(); ++a) {
      EXPECT_EQ(level.interpolation[level.anchors[a]].node(0), levels[l + 1].anchors[a]);
      EXPECT_EQ(level.interpolation[level.anchors[a]].weight(0), 1);
    }
  }
}

/// Sweeps over all levels below the finest for one over that.
double share_of_coarse_levels(const GraphMesh& mesh, const std::vector<std::uint32_t>& anchors) {
  const auto depths = multigrid::component_depths(mesh.graph, mesh.components, anchors);
  const auto levels =
      multigrid::build_hierarchy(mesh.graph, anchors, depths.front(), multigrid::Coarsening::kExact);
  const std::vector<int> cycles = multigrid::plan_cycles(levels);
  double visits = 1;
  double work = 0;
  for (std::size_t l = 1; l < levels.size(); ++l) {
    visits *= cycles[l];
    work += visits * static_cast<double>(multigrid::work_on(levels[l]));
  }
  return work / static_cast<double>(multigrid::work_on(levels.front()));
}

TEST(Multigrid, CyclesAreMadeTwiceWhereLevelsShrink) {
  const GraphMesh mesh = test::sheet(100, 100);
  const auto anchors = place_anchors(mesh.graph, mesh.components, {.count = 50}).vertices;
  EXPECT_LT(share_of_coarse_levels(mesh, anchors), 2);
  const auto levels = multigrid::build_hierarchy(mesh.graph, anchors, 3, multigrid::Coarsening::kExact);
  EXPECT_EQ(multigrid::plan_cycles(levels), (std::vector<int>{1, 2, 2, 2}));
}

TEST(Multigrid, WorkIsBoundedWhereLevelsHardlyShrink) {
  // A sheet of anchors only that hangs by one face on a sheet without.
  GraphMesh halves;
  test::add_sheet(halves, 80, 80, {});
  test::add_sheet(halves, 80, 80, {100, 0, 0});
  halves.triangles.insert(halves.triangles.end(), {0, 6400, 6401});
  halves = test::finish(std::move(halves));
  std::vector<std::uint32_t> anchors(6400);
  std::iota(anchors.begin(), anchors.end(), 0U);
  EXPECT_LT(share_of_coarse_levels(halves, anchors), 10);

  // A dense part at the end of a path.
  GraphMesh dense;
  constexpr std::uint32_t kDense = 90;
  constexpr std::uint32_t kPath = 8000;
  for (std::uint32_t v = 0; v < kDense + kPath; ++v) dense.positions.push_back({1.0 * v, 0, 0});
  for (std::uint32_t a = 0; a < kDense; ++a)
    for (std::uint32_t b = 0; b < a; ++b)
      dense.triangles.insert(dense.triangles.end(), {a, b, (a + 1) % kDense});
  for (std::uint32_t v = kDense; v + 1 < kDense + kPath; ++v)
    dense.triangles.insert(dense.triangles.end(), {v - 1, v, v + 1});
  dense = test::finish(std::move(dense));
  EXPECT_LT(share_of_coarse_levels(dense, {kDense + kPath - 1}), 10);
}

TEST(Multigrid, AggregatesAreASeedAndItsNeighbours) {
  const GraphMesh mesh = test::sheet(30, 30);
  const std::uint32_t anchors[] = {5, 6, 700};
  const auto levels = multigrid::build_hierarchy(mesh.graph, anchors, 0, multigrid::Coarsening::kExact);
  ASSERT_EQ(levels.size(), 1U);
  const multigrid::Aggregates aggregates = multigrid::aggregate(levels.front());
  for (const std::uint32_t anchor : anchors) EXPECT_TRUE(aggregates.is_seed(anchor));
  std::uint32_t last_seed = 0;
  std::size_t members = 0;
  for (std::uint32_t c = 0; c < aggregates.count(); ++c) {
    const std::uint32_t seed = aggregates.members_of(c).front();
    EXPECT_TRUE(aggregates.is_seed(seed));
    EXPECT_TRUE(c == 0 || seed > last_seed);
    last_seed = seed;
    members += aggregates.members_of(c).size();
    for (const std::uint32_t v : aggregates.members_of(c)) {
      EXPECT_EQ(aggregates.of(v), c);
      const auto neighbors = mesh.graph.of(v);
      EXPECT_TRUE(seed == v || std::binary_search(neighbors.begin(), neighbors.end(), seed));
    }
  }
  EXPECT_EQ(members, mesh.positions.size());
}

/// Of nodes with few neighbours, and of one with ten; the lower aggregates among equals.
TEST(Multigrid, NodesAreInterpolatedFromTheAggregatesNextToThem) {
  GraphMesh mesh = test::sheet(30, 30);
  mesh.triangles.insert(mesh.triangles.end(), {435, 438, 439, 435, 440, 441});
  mesh = test::finish(std::move(mesh));
  ASSERT_EQ(mesh.graph.degree(435), 10U);
  const std::uint32_t anchors[] = {5, 700};
  const auto levels = multigrid::build_hierarchy(mesh.graph, anchors, 0, multigrid::Coarsening::kExact);
  const multigrid::Aggregates aggregates = multigrid::aggregate(levels.front());
  ASSERT_FALSE(aggregates.is_seed(435));
  const auto interpolation = multigrid::make_interpolation(levels.front(), aggregates);
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    std::map<std::uint32_t, int> weights;
    for (const std::uint32_t other : mesh.graph.of(v))
      weights[aggregates.of(other)] += aggregates.is_seed(other) ? 4 : 1;
    if (aggregates.is_seed(v)) weights = {{aggregates.of(v), 1}};
    std::vector<std::pair<std::uint32_t, int>> heaviest(weights.begin(), weights.end());
    std::stable_sort(heaviest.begin(), heaviest.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    heaviest.resize(3);
    const auto sum = static_cast<float>(heaviest[0].second + heaviest[1].second + heaviest[2].second);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(interpolation[v].weight(k), static_cast<float>(heaviest[k].second) / sum, 1.01F / 16) << v;
      if (interpolation[v].weight(k) > 0) {
        EXPECT_EQ(interpolation[v].node(k), heaviest[k].first) << v;
      }
    }
  }
}

TEST(Multigrid, GroupsPartTheGraphByDepth) {
  const GraphMesh mesh = many_sheets();
  auto anchors = place_anchors(mesh.graph, mesh.components, {.count = 150}).vertices;
  const auto groups = multigrid::group_components(mesh.graph, mesh.components, anchors);
  std::vector<int> seen(mesh.positions.size(), 0);
  std::size_t anchors_seen = 0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (g > 0) {
      EXPECT_GT(groups[g].depth, groups[g - 1].depth);
    }
    for (const std::uint32_t v : groups[g].vertices) ++seen[v];
    for (std::size_t a = 0; a < groups[g].anchors.size(); ++a)
      EXPECT_EQ(groups[g].vertices[groups[g].anchors[a]], anchors[groups[g].anchor_of[a]]);
    anchors_seen += groups[g].anchors.size();
  }
  const auto is_small = [&](std::uint32_t v) {
    return mesh.components.size[mesh.components.label[v]] <= SmallComponents::kLargest;
  };
  for (std::uint32_t v = 0; v < seen.size(); ++v) EXPECT_EQ(seen[v], is_small(v) ? 0 : 1);
  EXPECT_EQ(anchors_seen, static_cast<std::size_t>(anchors.end() -
                                                   std::partition(anchors.begin(), anchors.end(), is_small)));
}

}  // namespace
}  // namespace deltamesh
