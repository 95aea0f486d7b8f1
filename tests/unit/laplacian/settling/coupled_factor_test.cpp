// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/coupled_factor.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "direct_solver/direct_solver.h"
#include "laplacian/operator/delta.h"
#include "laplacian/settling/steps.h"
#include "support/graph_mesh.h"
#include "support/random.h"

namespace deltamesh {
namespace {

using settling::CoupledFactor;
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

/// Three steps: what the factor finds is a float.
void expect_exact(const GraphMesh& mesh, std::uint32_t stride) {
  const Problem problem = make_problem(mesh, stride);
  auto factor = CoupledFactor::make(mesh.graph, problem.anchors);
  ASSERT_TRUE(factor);
  settling::Steps steps(mesh.graph, mesh.components, problem.anchors, problem.deltas, problem.targets, 1);
  for (int step = 0; step < 3; ++step) {
    steps.set_residual(factor->first());
    factor->solve();
    steps.take(factor->first());
  }
  std::vector<Vec3> exact(mesh.positions.size());
  test::DirectSolver(mesh.graph, problem.anchors).solve(problem.deltas, problem.targets, exact);
  for (std::uint32_t v = 0; v < exact.size(); ++v) {
    const auto& x = steps.x()[v];
    EXPECT_LT(length(Vec3{x.xy[0], x.xy[1], x.zw[0]} - exact[v]), 1e-7) << v;
  }
}

void add(const GraphMesh& part, GraphMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
  for (const std::uint32_t v : part.triangles) mesh.triangles.push_back(first + v);
}

/// Sheets, strips and fans, whose vertices follow each other.
GraphMesh many_shapes() {
  GraphMesh mesh;
  for (std::uint32_t i = 0; i < 40; ++i)
    test::add_sheet(mesh, 2 + i % 7, 2 + i / 3, {20.0 * (i % 8), 20.0 * (i / 8), 3});
  test::add_sheet(mesh, 32, 2, {0, 200, 0});
  for (const std::uint32_t rim : {7U, 31U, 63U, 64U, 65U, 300U}) add(test::fan(rim), mesh);
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

TEST(CoupledFactor, EqualsTheDirectSolver) {
  for (const std::uint32_t stride : {1U, 2U, 13U, 100000U}) {
    SCOPED_TRACE(stride);
    expect_exact(many_shapes(), stride);
  }
}

TEST(CoupledFactor, DoesNotAskForVerticesInARow) {
  expect_exact(shuffled(many_shapes()), 7);
  expect_exact(shuffled(many_shapes()), 100000);
}

/// Where everything is near everything there is no sparse factor, whatever the order.
TEST(CoupledFactor, RefusesWhatWouldBeFarFromSparse) {
  GraphMesh mesh;
  const std::uint32_t count = 3000;
  test::RandomBits random(7);
  const auto any = [&] { return static_cast<std::uint32_t>(random() % count); };
  mesh.positions.resize(count);
  for (std::uint32_t v = 0; v < count; ++v) {
    for (int k = 0; k < 4; ++k) mesh.triangles.insert(mesh.triangles.end(), {v, (v + 1) % count, any()});
  }
  mesh = test::finish(std::move(mesh));
  EXPECT_FALSE(CoupledFactor::make(mesh.graph, std::vector<std::uint32_t>{0}));
}

}  // namespace
}  // namespace deltamesh
