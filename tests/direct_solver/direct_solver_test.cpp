// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "direct_solver/direct_solver.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "laplacian/operator/delta.h"
#include "laplacian/solver.h"
#include "support/graph_mesh.h"
#include "support/random.h"

namespace deltamesh {
namespace {

using test::DirectSolver;
using test::GraphMesh;

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

TEST(DirectSolver, DELT4AgreesWithDenseLeastSquares) {
  for (const GraphMesh& mesh : {test::sheet(9, 8), test::fan(30), test::sheet(40, 2), test::sheet(5, 2)}) {
    for (const std::uint32_t count : {1U, 5U}) {
      const auto anchors = test::anchors_of(mesh, count);
      // A right-hand side that no positions satisfy: the residual is spread, not zero.
      std::vector<Vec3> deltas = delta_coordinates(mesh.graph, mesh.positions);
      for (std::size_t i = 0; i < deltas.size(); ++i) deltas[i][i % 3] += 0.1 * static_cast<double>(i % 4);
      std::vector<Vec3> targets = positions_at(mesh, anchors);
      targets.front()[1] += 0.5;

      const DirectSolver solver(mesh.graph, anchors);
      std::vector<Vec3> x(mesh.positions.size());
      solver.solve(deltas, targets, x);
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
      const auto anchors = test::anchors_of(mesh, count);
      std::vector<Vec3> deltas = delta_coordinates(mesh.graph, mesh.positions);
      for (std::size_t i = 0; i < deltas.size(); ++i) deltas[i][i % 3] += 0.1 * static_cast<double>(i % 4);
      const DirectSolver solver(mesh.graph, anchors);
      std::vector<Vec3> x(mesh.positions.size());
      solver.solve(deltas, positions_at(mesh, anchors), x);
      const auto expected = solve_dense(mesh.graph, anchors, deltas, positions_at(mesh, anchors));
      EXPECT_LT(largest_difference(x, expected), 1e-9);
    }
  }
}

/// `count` fans with a hub each, joined by strips.
GraphMesh chain_of_hubs(std::uint32_t count) {
  constexpr std::uint32_t kRim = 70;
  constexpr std::uint32_t kStrip = 60;
  GraphMesh mesh;
  std::uint32_t next = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (next > 0) mesh.triangles.insert(mesh.triangles.end(), {next - 1, next, next + 1});
    for (std::uint32_t k = 0; k < kRim; ++k)
      mesh.triangles.insert(mesh.triangles.end(), {next, next + 1 + k, next + 1 + (k + 1) % kRim});
    next += kRim + 1;
    mesh.triangles.insert(mesh.triangles.end(), {next - 1, next, next + 1});
    for (std::uint32_t k = 0; k + 2 < kStrip; ++k)
      mesh.triangles.insert(mesh.triangles.end(), {next + k, next + k + 1, next + k + 2});
    next += kStrip;
  }
  for (std::uint32_t v = 0; v < next; ++v)
    mesh.positions.push_back({0.1 * v, std::sin(0.3 * v), std::cos(0.2 * v)});
  return test::finish(std::move(mesh));
}

/// What a solution makes least.
double functional(const Adjacency& graph, const std::vector<std::uint32_t>& anchors,
                  const std::vector<Vec3>& deltas, const std::vector<Vec3>& targets,
                  const std::vector<Vec3>& x) {
  const std::vector<Vec3> own = delta_coordinates(graph, x);
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += dot(own[i] - deltas[i], own[i] - deltas[i]);
  for (std::size_t a = 0; a < anchors.size(); ++a)
    sum += dot(x[anchors[a]] - targets[a], x[anchors[a]] - targets[a]);
  return sum;
}

/// What keeps a hub's row apart makes refinement slow where few anchors hold many hubs.
TEST(DirectSolver, NoOtherSolutionIsBetterWithManyHubsAndOneAnchor) {
  const GraphMesh mesh = chain_of_hubs(100);
  const std::vector<std::uint32_t> anchors{0};
  const std::vector<Vec3> targets{{1, 2, 3}};
  test::RandomBits bits(7);
  const auto random = [&] { return bits() * 0x1p-32 - 0.5; };
  std::vector<Vec3> deltas;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) deltas.push_back({random(), random(), random()});
  std::vector<Vec3> x(mesh.positions.size());
  DirectSolver(mesh.graph, anchors).solve(deltas, targets, x);
  std::vector<Vec3> other(x.size());
  ASSERT_TRUE(PlannedSolver(mesh.graph, mesh.components).solve(anchors, deltas, targets, 12, other));
  EXPECT_LE(functional(mesh.graph, anchors, deltas, targets, x),
            functional(mesh.graph, anchors, deltas, targets, other));
}

TEST(DirectSolver, AHubOfManyNeighboursCostsNoMoreThanItsEdges) {
  const GraphMesh mesh = test::fan(100000);
  const std::vector<std::uint32_t> anchors{17};
  const DirectSolver solver(mesh.graph, anchors);
  std::vector<Vec3> x(mesh.positions.size());
  solver.solve(delta_coordinates(mesh.graph, mesh.positions), positions_at(mesh, anchors), x);
  EXPECT_LT(largest_difference(x, mesh.positions), 1e-6);
}

TEST(DirectSolver, ReturnsThePositionsThatExactDeltasCameFrom) {
  const GraphMesh mesh = test::sheet(60, 50);
  const auto anchors = test::anchors_of(mesh, 15);
  const DirectSolver solver(mesh.graph, anchors);
  std::vector<Vec3> x(mesh.positions.size());
  solver.solve(delta_coordinates(mesh.graph, mesh.positions), positions_at(mesh, anchors), x);
  EXPECT_LT(largest_difference(x, mesh.positions), 1e-9);
}

TEST(DirectSolver, ServesManyRightHandSides) {
  const GraphMesh mesh = test::sheet(12, 12);
  const std::vector<std::uint32_t> anchors{0, 77, 143};
  const DirectSolver solver(mesh.graph, anchors);
  std::vector<Vec3> x(mesh.positions.size());
  std::vector<Vec3> twice(mesh.positions.size());
  const auto deltas = delta_coordinates(mesh.graph, mesh.positions);
  solver.solve(std::vector<Vec3>(deltas.size()), positions_at(mesh, anchors), twice);
  solver.solve(deltas, positions_at(mesh, anchors), x);
  solver.solve(deltas, positions_at(mesh, anchors), twice);
  EXPECT_EQ(x, twice);
}

}  // namespace
}  // namespace deltamesh
