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
using test::renumbered;

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
  std::uint64_t work_left = 1U << 31;
  auto factor = CoupledFactor::make(mesh.graph, problem.anchors, work_left);
  ASSERT_TRUE(factor);
  EXPECT_LT(work_left, 1U << 31);
  settling::Steps steps({mesh.graph, mesh.components, problem.anchors, problem.deltas, problem.targets}, 1);
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

TEST(CoupledFactor, EqualsTheDirectSolver) {
  for (const std::uint32_t stride : {1U, 2U, 13U, 100000U}) {
    SCOPED_TRACE(stride);
    expect_exact(many_shapes(), stride);
  }
}

TEST(CoupledFactor, DoesNotAskForVerticesInARow) {
  expect_exact(renumbered(many_shapes()), 7);
  expect_exact(renumbered(many_shapes()), 100000);
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
  std::uint64_t work_left = std::uint64_t{1} << 32;
  EXPECT_FALSE(CoupledFactor::make(mesh.graph, std::vector<std::uint32_t>{0}, work_left));
}

TEST(CoupledFactor, TakesNoMoreWorkThanThereIs) {
  const GraphMesh mesh = test::sheet(30, 30);
  constexpr std::uint64_t kEnough = 1U << 31;
  std::uint64_t work_left = kEnough;
  ASSERT_TRUE(CoupledFactor::make(mesh.graph, std::vector<std::uint32_t>{0}, work_left));
  const std::uint64_t work = kEnough - work_left;
  for (const std::uint64_t missing : {0U, 1U}) {
    work_left = work - missing;
    EXPECT_EQ(CoupledFactor::make(mesh.graph, std::vector<std::uint32_t>{0}, work_left).has_value(),
              missing == 0);
    EXPECT_EQ(work_left, 0);
  }
}

}  // namespace
}  // namespace deltamesh
