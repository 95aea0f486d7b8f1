// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Rows of levels and the coupled problem on one. Values are whole numbers, whose sums are exact in floats.
#include "laplacian/multigrid/level/level.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "laplacian/multigrid/level/coupled_problem.h"
#include "laplacian/multigrid/level/edges.h"
#include "laplacian/multigrid/level/interpolation.h"
#include "laplacian/multigrid/level/row.h"
#include "laplacian/multigrid/level/unit_edges.h"
#include "laplacian/multigrid/setup/levels.h"
#include "support/graph_mesh.h"
#include "support/random.h"
#include "unit/laplacian/finest_level.h"

namespace deltamesh::level_test {
namespace {

using multigrid::Float4;
using multigrid::Interpolation;
using multigrid::Level;
using multigrid::Row;
using test::GraphMesh;

/// From -8 to 8, on three axes.
std::vector<Float4> whole_numbers(std::size_t count, std::uint32_t seed) {
  test::RandomBits random(seed);
  const auto next = [&] { return static_cast<float>(random() % 17) - 8; };
  std::vector<Float4> values(count);
  for (Float4& v : values) {
    for (std::size_t axis = 0; axis < 3; ++axis) v[axis] = next();
  }
  return values;
}

void expect_equal(Float4 a, Float4 b) {
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(a[k], b[k]);
}

TEST(Interpolation, WeightsAreSixteenthsThatAddUpToOne) {
  for (std::uint32_t second = 0; second < 15; ++second) {
    for (std::uint32_t third = 0; second + third < 15; ++third) {
      const Interpolation row({5, Interpolation::kMostNodes - 1, 0}, second, third);
      EXPECT_EQ(row.node(0), 5U);
      EXPECT_EQ(row.node(1), Interpolation::kMostNodes - 1);
      EXPECT_EQ(row.node(2), 0U);
      EXPECT_EQ(row.weight(0) + row.weight(1) + row.weight(2), 1);
      EXPECT_EQ(16 * row.weight(1), static_cast<float>(second));
      EXPECT_EQ(16 * row.weight(2), static_cast<float>(third));
      EXPECT_TRUE(row.counts(0));
      EXPECT_EQ(row.counts(1), second > 0);
      EXPECT_EQ(row.counts(2), third > 0);
    }
  }
}

TEST(Interpolation, OneNode) {
  const std::vector<float> coarse{3, 4, 5};
  EXPECT_EQ(Interpolation(2).of(coarse), 5);
}

/// <P c, f> = <c, P^T f>.
TEST(Interpolation, SpreadIsTheTransposeOfOf) {
  test::RandomBits random(1);
  std::vector<float> coarse(10);
  for (float& value : coarse) value = static_cast<float>(random() % 100);
  std::vector<float> spread(coarse.size());
  float of = 0;
  for (int i = 0; i < 50; ++i) {
    const std::uint32_t second = random() % 8;
    const Interpolation row({random() % 10, random() % 10, random() % 10}, second, random() % 8);
    const auto fine = static_cast<float>(random() % 50);
    of += fine * row.of(coarse);
    row.spread(fine, [&](std::uint32_t node) -> float& { return spread[node]; });
  }
  float transposed = 0;
  for (std::size_t c = 0; c < coarse.size(); ++c) transposed += coarse[c] * spread[c];
  EXPECT_EQ(of, transposed);
}

TEST(Edges, LowerAndHigherNeighboursAreAllNeighbours) {
  for (const GraphMesh& mesh : {test::sheet(9, 6), test::fan(12)}) {
    Level level = test::finest_level(mesh, {0});
    for (std::size_t e = 0; e < level.weights.size(); ++e) level.weights[e] = static_cast<float>(1 + e % 3);
    const std::vector<Float4> values = whole_numbers(level.node_count(), 2);
    const auto value = [&](std::uint32_t node) { return values[node]; };
    const multigrid::Edges edges(level);
    for (std::uint32_t v = 0; v < level.node_count(); ++v) {
      Float4 lower{};
      Float4 higher{};
      for (std::uint32_t e = level.offsets[v]; e < level.offsets[v + 1]; ++e) {
        const std::uint32_t other = level.neighbors[e];
        (other < v ? lower : higher) += level.weights[e] * values[other];
      }
      expect_equal(edges.sum_lower(v, value), lower);
      expect_equal(edges.sum_higher(v, value), higher);
      expect_equal(edges.sum_all(v, value), lower + higher);
    }
  }
}

/// Rows of six neighbours, and of other numbers.
TEST(UnitEdges, AllWeightsAreOne) {
  for (const GraphMesh& mesh : {test::sheet(9, 6), test::fan(12)}) {
    const Level level = test::finest_level(mesh, {0});
    std::vector<Float4> values = whole_numbers(level.node_count(), 3);
    values.push_back(Float4{});
    const multigrid::UnitEdges edges(level);
    ASSERT_EQ(edges.node_count(), level.node_count());
    for (std::uint32_t v = 0; v < level.node_count(); ++v) {
      Float4 all{};
      Float4 higher{};
      for (const std::uint32_t other : mesh.graph.of(v)) {
        all += values[other];
        if (other > v) higher += values[other];
      }
      const std::uint32_t degree = mesh.graph.degree(v);
      edges.with_row(v, [&](const auto& row) {
        EXPECT_EQ(row.degree(), static_cast<float>(degree));
        EXPECT_EQ(row.inverse_degree(), 1 / static_cast<float>(degree));
        expect_equal(row.sum(values.data()), all);
        expect_equal(row.sum_floats([&](std::uint32_t node) { return values[node]; }), all);
        expect_equal(row.upper(values.data()), higher);
        expect_equal(row.add_scaled(values.data(), values[v], 4), values[v] + 4 * all);
        EXPECT_EQ(row.times(FourUnsigned{7, 0, 0, 1})[0], 7 * degree);
        EXPECT_EQ(row.times(FourUnsigned{7, 0, 0, 1})[3], degree);
      });
    }
  }
}

TEST(Double4, RatiosByNothingAreNothing) {
  const multigrid::Double4 a{TwoDoubles{1, 2}, TwoDoubles{3, 4}};
  const multigrid::Double4 b{TwoDoubles{2, 0}, TwoDoubles{-1, 8}};
  const multigrid::Double4 quotients = multigrid::ratio(a, b);
  EXPECT_EQ(quotients.xy[0], 0.5);
  EXPECT_EQ(quotients.xy[1], 0);
  EXPECT_EQ(quotients.zw[0], 0);
  EXPECT_EQ(quotients.zw[1], 0.5);
  expect_equal(multigrid::narrow(multigrid::widen(Float4{1, 2, 3, 4})), Float4{1, 2, 3, 4});
}

/// A coupled problem, `share` of whose solution a cycle has found. On the third axis all is 0.
struct Coupled {
  std::vector<Row> b;
  std::vector<Row> u;
  std::vector<Float4> gaps;
  std::vector<Float4> forces;

  Coupled(const Level& level, float share) {
    const std::size_t n = level.node_count();
    const multigrid::Edges edges(level);
    std::vector<Float4> values = whole_numbers(2 * n + level.anchors.size(), 4);
    for (Float4& v : values) v[2] = 0;
    std::vector<Row> exact(n);
    for (std::size_t i = 0; i < n; ++i) exact[i] = {values[i], values[n + i]};
    for (std::uint32_t i = 0; i < n; ++i) {
      const Row k = level.degree[i] * exact[i] +
                    -1 * edges.sum_all(i, [&](std::uint32_t other) { return exact[other]; });
      b.push_back({k.x + level.mass[i] * exact[i].s, k.s});
      u.push_back(share * exact[i]);
    }
    for (std::size_t a = 0; a < level.anchors.size(); ++a) {
      const Float4 gap = values[2 * n + a];
      const Float4 force = exact[level.anchors[a]].x - gap;
      gaps.push_back(gap);
      forces.push_back(share * force);
      // After a cycle b.s has the forces that were found added; so far it has all.
      b[level.anchors[a]].s += (share - 1) * force;
    }
  }

  multigrid::CoupledProblem on(const Level& level) { return {level, b, u, gaps, forces}; }
};

TEST(CoupledProblem, DELT7TheBestLengthLeavesNothingOfWhatACycleFoundInPart) {
  const GraphMesh mesh = test::sheet(9, 8);
  const Level level = test::finest_level(mesh, {3, 40, 41, 70});
  for (const float share : {1.0F, 0.5F, 0.125F, 4.0F}) {
    Coupled problem(level, share);
    std::vector<Row> image(level.node_count());
    const Float4 length = multigrid::best_length(problem.on(level), image);
    EXPECT_FLOAT_EQ(length[0], 1 / share);
    EXPECT_FLOAT_EQ(length[1], 1 / share);
    EXPECT_EQ(length[2], 0) << "nothing was found there";
    EXPECT_EQ(length[3], 0);
    expect_equal(multigrid::best_length(problem.on(level), {}), length);
    multigrid::take_off(problem.on(level), Float4{1 / share, 1 / share, 0, 0}, image, nullptr);
    for (const Row& b : problem.b) {
      expect_equal(b.x, Float4{});
      expect_equal(b.s, Float4{});
    }
    for (const Float4& gap : problem.gaps) expect_equal(gap, Float4{});
  }
}

/// Along the best length the functional has its least value: its slope there is 0.
TEST(CoupledProblem, DELT7AfterTheBestLengthTheSameDirectionGivesNothing) {
  const GraphMesh mesh = test::sheet(9, 8);
  const Level level = test::finest_level(mesh, {3, 40, 41, 70});
  Coupled problem(level, 1);
  const std::vector<Float4> off = whole_numbers(level.node_count(), 5);
  for (std::size_t i = 0; i < off.size(); ++i) problem.u[i].x += off[i];
  std::vector<Row> image(level.node_count());
  const Float4 length = multigrid::best_length(problem.on(level), image);
  multigrid::take_off(problem.on(level), length, image, nullptr);
  // A cycle that found the same once more.
  for (std::size_t a = 0; a < level.anchors.size(); ++a) problem.b[level.anchors[a]].s += problem.forces[a];
  const Float4 again = multigrid::best_length(problem.on(level), {});
  for (std::size_t axis = 0; axis < 2; ++axis) {
    EXPECT_GT(length[axis], 0.1F);
    EXPECT_NEAR(again[axis], 0, 1e-4);
  }
}

}  // namespace
}  // namespace deltamesh::level_test
