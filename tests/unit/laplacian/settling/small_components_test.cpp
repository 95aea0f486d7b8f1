// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/small_components.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "laplacian/operator/delta.h"
#include "laplacian/solver.h"
#include "support/graph_mesh.h"
#include "support/random.h"

namespace deltamesh {
namespace {

using settling::SmallComponents;
using test::GraphMesh;

struct Problem {
  std::vector<std::uint32_t> anchors;
  std::vector<Vec3> deltas;
  std::vector<Vec3> targets;
};

/// One anchor in every component, its first vertex, and every `stride`-th vertex. Deltas and targets that no
/// positions have.
Problem make_problem(const GraphMesh& mesh, std::uint32_t stride) {
  Problem problem;
  test::RandomBits random(5);
  std::vector<std::uint8_t> seen(mesh.components.count, 0);
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    std::uint8_t& has_anchor = seen[mesh.components.label[v]];
    if (has_anchor == 0 || v % stride == 0) problem.anchors.push_back(v);
    has_anchor = 1;
  }
  const auto noise = [&] { return 1e-11 * random(); };
  problem.deltas = delta_coordinates(mesh.graph, mesh.positions);
  for (Vec3& delta : problem.deltas) delta = delta + Vec3{noise(), noise(), noise()};
  for (const std::uint32_t a : problem.anchors)
    problem.targets.push_back(mesh.positions[a] + Vec3{noise(), noise(), noise()});
  return problem;
}

void expect_exact(const GraphMesh& mesh, std::uint32_t stride) {
  const Problem problem = make_problem(mesh, stride);
  const SmallComponents small(mesh.graph, mesh.components, problem.anchors);
  const Vec3 untouched{77, 77, 77};
  std::vector<Vec3> x(mesh.positions.size(), untouched);
  ASSERT_TRUE(small.solve(problem.deltas, problem.targets, x));
  const auto direct = make_direct_solver(mesh.graph, problem.anchors);
  ASSERT_TRUE(direct);
  std::vector<Vec3> exact(x.size());
  ASSERT_TRUE((*direct)->solve(problem.deltas, problem.targets, exact));
  for (std::uint32_t v = 0; v < x.size(); ++v) {
    if (mesh.components.size[mesh.components.label[v]] > SmallComponents::kLargest) {
      EXPECT_EQ(x[v], untouched);
    } else if (mesh.graph.degree(v) > 0) {
      EXPECT_LT(length(x[v] - exact[v]), 1e-7) << v;
    }
  }
}

/// Sheets, strips and fans of up to 64 vertices, and some larger, whose vertices follow each other.
GraphMesh many_shapes() {
  GraphMesh mesh;
  for (std::uint32_t i = 0; i < 40; ++i)
    test::add_sheet(mesh, 2 + i % 7, 2 + i / 3, {20.0 * (i % 8), 20.0 * (i / 8), 3});
  test::add_sheet(mesh, 32, 2, {0, 200, 0});
  for (const std::uint32_t rim : {7U, 31U, 63U, 64U}) {
    const GraphMesh fan = test::fan(rim);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), fan.positions.begin(), fan.positions.end());
    for (const std::uint32_t v : fan.triangles) mesh.triangles.push_back(first + v);
  }
  mesh.positions.push_back({5, 5, 5});
  return test::finish(std::move(mesh));
}

/// The same shape with the vertices of all components mixed.
GraphMesh shuffled(const GraphMesh& mesh) {
  GraphMesh result;
  const std::size_t n = mesh.positions.size();
  std::size_t stride = 1009;
  while (n % stride == 0) stride += 2;
  std::vector<std::uint32_t> place(n);
  result.positions.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    place[i] = static_cast<std::uint32_t>(i * stride % n);
    result.positions[place[i]] = mesh.positions[i];
  }
  for (const std::uint32_t v : mesh.triangles) result.triangles.push_back(place[v]);
  return test::finish(std::move(result));
}

TEST(SmallComponents, EqualTheDirectSolver) {
  for (const std::uint32_t stride : {1U, 2U, 13U, 100000U}) {
    SCOPED_TRACE(stride);
    expect_exact(many_shapes(), stride);
    expect_exact(test::fragments(), stride);
  }
}

TEST(SmallComponents, DoNotAskForVerticesInARow) {
  expect_exact(shuffled(many_shapes()), 7);
  expect_exact(shuffled(many_shapes()), 100000);
}

TEST(SmallComponents, LoneAnchorsKeepTheirPlace) {
  GraphMesh mesh;
  mesh.positions = {{1, 2, 3}, {4, 5, 6}};
  mesh = test::finish(std::move(mesh));
  const std::vector<std::uint32_t> anchors = {0, 1};
  std::vector<Vec3> x(2);
  const SmallComponents small(mesh.graph, mesh.components, anchors);
  ASSERT_TRUE(small.solve(std::vector<Vec3>(2, Vec3{9, 9, 9}), mesh.positions, x));
  EXPECT_EQ(x, mesh.positions);
}

TEST(SmallComponents, DELT4RefusesAComponentWithoutAnchor) {
  const GraphMesh mesh = test::fragments();
  const std::vector<std::uint32_t> anchors = {0};
  std::vector<Vec3> x(mesh.positions.size());
  const auto result =
      SmallComponents(mesh.graph, mesh.components, anchors)
          .solve(delta_coordinates(mesh.graph, mesh.positions), std::span(mesh.positions).first(1), x);
  ASSERT_FALSE(result);
  EXPECT_STREQ(result.error().rule, "DELT-4");
}

TEST(SmallComponents, AreNoneInALargeMesh) {
  const GraphMesh mesh = test::sheet(13, 5);
  const std::vector<std::uint32_t> anchors = {3};
  EXPECT_TRUE(SmallComponents(mesh.graph, mesh.components, anchors).empty());
}

}  // namespace
}  // namespace deltamesh
