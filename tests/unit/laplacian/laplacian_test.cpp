// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "laplacian/anchors/anchors.h"
#include "laplacian/operator/delta.h"
#include "laplacian/operator/solved_part.h"
#include "laplacian/solver.h"
#include "support/graph_mesh.h"

namespace deltamesh {
namespace {

using test::GraphMesh;

/// Hop distance to the nearest anchor by plain relaxation until nothing changes; 1000 where none is reached.
std::vector<std::uint32_t> hops_by_relaxation(const Adjacency& graph,
                                              const std::vector<std::uint32_t>& anchors) {
  std::vector<std::uint32_t> hops(graph.vertex_count(), 1000);
  for (const std::uint32_t anchor : anchors) hops[anchor] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::uint32_t v = 0; v < hops.size(); ++v) {
      for (const std::uint32_t w : graph.of(v)) {
        if (hops[v] <= hops[w] + 1) continue;
        hops[v] = hops[w] + 1;
        changed = true;
      }
    }
  }
  return hops;
}

std::vector<Vec3> positions_at(const GraphMesh& mesh, const std::vector<std::uint32_t>& vertices) {
  std::vector<Vec3> result;
  for (const std::uint32_t vertex : vertices) result.push_back(mesh.positions[vertex]);
  return result;
}

double largest_difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, length(a[i] - b[i]));
  return largest;
}

/// The least-squares solution by dense QR of the rectangular system [L; anchors].
std::vector<Vec3> solve_dense(const Adjacency& graph, const std::vector<std::uint32_t>& anchors,
                              const std::vector<Vec3>& deltas, const std::vector<Vec3>& anchor_positions) {
  const auto n = static_cast<Eigen::Index>(graph.vertex_count());
  const auto k = static_cast<Eigen::Index>(anchors.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + k, n);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n + k, 3);
  for (std::uint32_t i = 0; i < graph.vertex_count(); ++i) {
    matrix(i, i) = 1;
    for (const std::uint32_t j : graph.of(i)) matrix(i, j) = -1.0 / graph.degree(i);
    for (int axis = 0; axis < 3; ++axis) right(i, axis) = deltas[i][static_cast<std::size_t>(axis)];
  }
  for (Eigen::Index a = 0; a < k; ++a) {
    matrix(n + a, anchors[static_cast<std::size_t>(a)]) = 1;
    for (int axis = 0; axis < 3; ++axis)
      right(n + a, axis) = anchor_positions[static_cast<std::size_t>(a)][static_cast<std::size_t>(axis)];
  }
  const Eigen::MatrixXd x = matrix.householderQr().solve(right);
  std::vector<Vec3> result(graph.vertex_count());
  for (Eigen::Index i = 0; i < n; ++i) result[static_cast<std::size_t>(i)] = {x(i, 0), x(i, 1), x(i, 2)};
  return result;
}

TEST(Delta, IsTheOffsetFromTheMeanOfTheNeighbours) {
  const GraphMesh mesh =
      test::finish({.positions = {{0, 0, 0}, {2, 0, 0}, {0, 4, 0}, {9, 9, 9}}, .triangles = {0, 1, 2}});
  const std::vector<Vec3> deltas = delta_coordinates(mesh.graph, mesh.positions);
  EXPECT_EQ(deltas[0], (Vec3{-1, -2, 0}));
  EXPECT_EQ(deltas[1], (Vec3{2, -2, 0}));
  EXPECT_EQ(deltas[2], (Vec3{-1, 4, 0}));
  EXPECT_EQ(deltas[3], (Vec3{0, 0, 0}));
  EXPECT_EQ(delta_range(deltas), 6);
  EXPECT_EQ(delta_range({}), 0);
}

TEST(Anchors, CountIsMetAndCoverageIsTheReportedDensity) {
  const GraphMesh mesh = test::sheet(30, 20);
  for (const std::uint32_t count : {1U, 2U, 7U, 60U}) {
    const Anchors anchors = place_anchors(mesh.graph, mesh.components, {.count = count});
    EXPECT_EQ(anchors.vertices.size(), count);
    EXPECT_TRUE(std::is_sorted(anchors.vertices.begin(), anchors.vertices.end()));
    const auto hops = hops_by_relaxation(mesh.graph, anchors.vertices);
    EXPECT_EQ(*std::max_element(hops.begin(), hops.end()), anchors.density);
  }
}

TEST(Anchors, DensityIsMet) {
  const GraphMesh mesh = test::sheet(30, 20);
  std::size_t fewer = 0;
  for (const std::uint32_t density : {15U, 8U, 3U, 1U}) {
    const Anchors anchors = place_anchors(mesh.graph, mesh.components, {.density = density});
    const auto hops = hops_by_relaxation(mesh.graph, anchors.vertices);
    EXPECT_LE(*std::max_element(hops.begin(), hops.end()), density);
    EXPECT_LE(anchors.density, density);
    EXPECT_GT(anchors.vertices.size(), fewer);
    fewer = anchors.vertices.size();
  }
}

TEST(Anchors, NoMoreThanThereAreVertices) {
  const GraphMesh mesh = test::sheet(4, 3);
  const Anchors anchors = place_anchors(mesh.graph, mesh.components, {.count = 1000000});
  EXPECT_EQ(anchors.vertices.size(), 12U);
  EXPECT_EQ(anchors.density, 0U);
}

TEST(Anchors, DefaultIsOneForEveryTwoHundredVertices) {
  const GraphMesh mesh = test::sheet(41, 20);
  EXPECT_EQ(place_anchors(mesh.graph, mesh.components, {}).vertices.size(), 5U);
}

TEST(Anchors, ANCH2CoverEveryComponentAndAllOfSmallOnes) {
  const GraphMesh mesh = test::fragments();
  const Anchors anchors = place_anchors(mesh.graph, mesh.components, {.count = 0});
  std::vector<std::uint32_t> in_component(mesh.components.count, 0);
  for (const std::uint32_t anchor : anchors.vertices) ++in_component[mesh.components.label[anchor]];
  for (std::uint32_t c = 0; c < mesh.components.count; ++c)
    EXPECT_EQ(in_component[c], mesh.components.size[c] < 8 ? mesh.components.size[c] : 1U);
  EXPECT_EQ(place_anchors(mesh.graph, mesh.components, {.count = 5}).vertices.size(), 8U + 5U);
}

TEST(Anchors, EmptyGraphHasNone) {
  const GraphMesh mesh = test::finish({});
  EXPECT_TRUE(place_anchors(mesh.graph, mesh.components, {}).vertices.empty());
}

TEST(SolvedPart, LeavesSmallComponentsOut) {
  const GraphMesh mesh = test::fragments();
  const SolvedPart part = extract_solved_part(mesh.graph, mesh.components);
  ASSERT_EQ(part.vertices.size(), 63U + 8U);
  ASSERT_EQ(part.row_count, 63U + 8U);
  EXPECT_FALSE(part.is_whole());
  EXPECT_FALSE(part.row_of(63));
  const Components components = find_components(part.graph);
  EXPECT_EQ(part.components.count, components.count);
  EXPECT_EQ(part.components.label, components.label);
  EXPECT_EQ(part.components.size, components.size);
  for (std::uint32_t row = 0; row < part.vertices.size(); ++row) {
    EXPECT_EQ(part.row_of(part.vertex(row)), row);
    ASSERT_EQ(part.graph.degree(row), mesh.graph.degree(part.vertex(row)));
    for (std::size_t k = 0; k < part.graph.of(row).size(); ++k)
      EXPECT_EQ(part.vertex(part.graph.of(row)[k]), mesh.graph.of(part.vertex(row))[k]);
  }
}

TEST(SolvedPart, IsTheWholeGraphWhereNothingIsSmall) {
  const GraphMesh mesh = test::sheet(5, 4);
  const SolvedPart part = extract_solved_part(mesh.graph, mesh.components);
  EXPECT_TRUE(part.is_whole());
  EXPECT_EQ(part.vertices.runs().size(), 1U);
  EXPECT_EQ(part.vertex(7), 7U);
  EXPECT_EQ(part.row_of(7), 7U);
  EXPECT_EQ(part.graph.neighbors, mesh.graph.neighbors);
}

TEST(DirectSolver, DELT4AgreesWithDenseLeastSquares) {
  for (const GraphMesh& mesh : {test::sheet(9, 8), test::fan(30), test::sheet(40, 2), test::sheet(5, 2)}) {
    for (const std::uint32_t count : {1U, 5U}) {
      const auto anchors = place_anchors(mesh.graph, mesh.components, {.count = count}).vertices;
      // A right-hand side that no positions satisfy: the residual is spread, not zero.
      std::vector<Vec3> deltas = delta_coordinates(mesh.graph, mesh.positions);
      for (std::size_t i = 0; i < deltas.size(); ++i) deltas[i][i % 3] += 0.1 * static_cast<double>(i % 4);
      std::vector<Vec3> targets = positions_at(mesh, anchors);
      targets.front()[1] += 0.5;

      const auto solver = make_direct_solver(mesh.graph, anchors);
      ASSERT_TRUE(solver);
      std::vector<Vec3> x(mesh.positions.size());
      ASSERT_TRUE((*solver)->solve(deltas, targets, x));
      EXPECT_LT(largest_difference(x, solve_dense(mesh.graph, anchors, deltas, targets)), 1e-8);
    }
  }
}

TEST(DirectSolver, AgreesWithDenseLeastSquaresAroundHubs) {
  GraphMesh clique;  // every vertex is a hub
  for (std::uint32_t i = 0; i < 90; ++i) {
    clique.positions.push_back({std::sin(1.0 * i), std::cos(2.0 * i), 0.1 * i});
    for (std::uint32_t j = 0; j < i; ++j) clique.triangles.insert(clique.triangles.end(), {i, j, j});
  }
  clique = test::finish(std::move(clique));
  ASSERT_EQ(clique.graph.degree(0), 89U);
  for (const GraphMesh& mesh : {test::fan(300), clique}) {
    for (const std::uint32_t count : {1U, 4U}) {
      const auto anchors = place_anchors(mesh.graph, mesh.components, {.count = count}).vertices;
      std::vector<Vec3> deltas = delta_coordinates(mesh.graph, mesh.positions);
      for (std::size_t i = 0; i < deltas.size(); ++i) deltas[i][i % 3] += 0.1 * static_cast<double>(i % 4);
      const auto solver = make_direct_solver(mesh.graph, anchors);
      ASSERT_TRUE(solver);
      std::vector<Vec3> x(mesh.positions.size());
      ASSERT_TRUE((*solver)->solve(deltas, positions_at(mesh, anchors), x));
      const auto expected = solve_dense(mesh.graph, anchors, deltas, positions_at(mesh, anchors));
      EXPECT_LT(largest_difference(x, expected), 1e-9);
    }
  }
}

TEST(DirectSolver, AHubOfManyNeighboursCostsNoMoreThanItsEdges) {
  const GraphMesh mesh = test::fan(100000);
  const std::vector<std::uint32_t> anchors{17};
  const auto solver = make_direct_solver(mesh.graph, anchors);
  ASSERT_TRUE(solver);
  std::vector<Vec3> x(mesh.positions.size());
  ASSERT_TRUE(
      (*solver)->solve(delta_coordinates(mesh.graph, mesh.positions), positions_at(mesh, anchors), x));
  EXPECT_LT(largest_difference(x, mesh.positions), 1e-6);
}

TEST(DirectSolver, ReturnsThePositionsThatExactDeltasCameFrom) {
  const GraphMesh mesh = test::sheet(60, 50);
  const auto anchors = place_anchors(mesh.graph, mesh.components, {}).vertices;
  const auto solver = make_direct_solver(mesh.graph, anchors);
  ASSERT_TRUE(solver);
  std::vector<Vec3> x(mesh.positions.size());
  ASSERT_TRUE(
      (*solver)->solve(delta_coordinates(mesh.graph, mesh.positions), positions_at(mesh, anchors), x));
  EXPECT_LT(largest_difference(x, mesh.positions), 1e-9);
}

TEST(DirectSolver, ServesManyRightHandSides) {
  const GraphMesh mesh = test::sheet(12, 12);
  const std::vector<std::uint32_t> anchors{0, 77, 143};
  const auto solver = make_direct_solver(mesh.graph, anchors);
  ASSERT_TRUE(solver);
  std::vector<Vec3> x(mesh.positions.size());
  std::vector<Vec3> twice(mesh.positions.size());
  const auto deltas = delta_coordinates(mesh.graph, mesh.positions);
  ASSERT_TRUE((*solver)->solve(std::vector<Vec3>(deltas.size()), positions_at(mesh, anchors), twice));
  ASSERT_TRUE((*solver)->solve(deltas, positions_at(mesh, anchors), x));
  ASSERT_TRUE((*solver)->solve(deltas, positions_at(mesh, anchors), twice));
  EXPECT_EQ(x, twice);
}

}  // namespace
}  // namespace deltamesh
