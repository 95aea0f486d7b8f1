// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/steps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "laplacian/multigrid/cycle/level_solver.h"
#include "support/random.h"
#include "unit/laplacian/solver_problem.h"

namespace deltamesh {
namespace {

using settling::Steps;
using test::SolverProblem;
using Vectors = multigrid::LevelSolver::Vectors;

constexpr double kUnit = 64;

Steps make_steps(const SolverProblem& problem) {
  return {{problem.mesh.graph, problem.mesh.components, problem.anchors, problem.deltas, problem.targets},
          kUnit};
}

Vectors room_for(const SolverProblem& problem) {
  Vectors vectors;
  vectors.b.resize(problem.deltas.size());
  vectors.u.resize(problem.deltas.size());
  vectors.gaps.resize(problem.anchors.size());
  vectors.forces.resize(problem.anchors.size());
  return vectors;
}

void propose_noise(Vectors& vectors, test::RandomBits& random) {
  const auto noise = [&] {
    const auto coordinate = [&] {
      return static_cast<float>(std::ldexp(1.0 * (random() % 2048), -11) - 0.5);
    };
    return multigrid::Float4{coordinate(), coordinate(), coordinate(), 0};
  };
  for (multigrid::Row& row : vectors.u) row = {noise(), noise()};
  for (multigrid::Float4& force : vectors.forces) force = noise();
}

/// Per component, over kUnit^2.
std::vector<double> functionals(const SolverProblem& problem, const Steps& steps) {
  const Adjacency& graph = problem.mesh.graph;
  std::vector<double> result(problem.mesh.components.count, 0.0);
  const auto at = [&](std::size_t v) {
    const auto& x = steps.x()[v];
    return Vec3{x.xy[0], x.xy[1], x.zw[0]};
  };
  for (std::uint32_t v = 0; v < problem.deltas.size(); ++v) {
    Vec3 mean{};
    for (const std::uint32_t other : graph.of(v)) mean = mean + (1.0 / graph.degree(v)) * at(other);
    const Vec3 left = (1 / kUnit) * problem.deltas[v] - at(v) + mean;
    result[problem.mesh.components.label[v]] += dot(left, left);
  }
  for (std::size_t a = 0; a < problem.anchors.size(); ++a) {
    const Vec3 gap = (1 / kUnit) * problem.targets[a] - at(problem.anchors[a]);
    result[problem.mesh.components.label[problem.anchors[a]]] += dot(gap, gap);
  }
  return result;
}

/// Whatever is proposed.
TEST(Steps, NeverRaiseTheFunctionalOfAComponent) {
  const SolverProblem problem = test::quantized(test::many_sheets(), 100, 8);
  Steps steps = make_steps(problem);
  Vectors vectors = room_for(problem);
  test::RandomBits random(3);
  std::vector<double> before = functionals(problem, steps);
  for (int step = 0; step < 6; ++step) {
    propose_noise(vectors, random);
    steps.take(vectors);
    const std::vector<double> after = functionals(problem, steps);
    for (std::size_t c = 0; c < after.size(); ++c) {
      EXPECT_LE(after[c], before[c] * (1 + 1e-12));
      EXPECT_NEAR(steps.progress()[c].functional, after[c], 1e-9 * (1 + after[c]));
      EXPECT_NEAR(steps.progress()[c].decrease, before[c] - after[c], 1e-9 * (1 + before[c]));
    }
    before = after;
  }
}

/// So that a solver which finds 0 for 0 has nothing to propose there.
TEST(Steps, NothingIsLeftOfAnExactSolution) {
  SolverProblem problem = test::quantized(test::sheet(30, 20), 6, 8);
  problem.deltas = delta_coordinates(problem.mesh.graph, problem.mesh.positions);
  for (std::size_t a = 0; a < problem.anchors.size(); ++a)
    problem.targets[a] = problem.mesh.positions[problem.anchors[a]];
  Steps steps = make_steps(problem);
  Vectors vectors = room_for(problem);
  for (std::size_t v = 0; v < vectors.u.size(); ++v)
    vectors.u[v] = {multigrid::to_float4((1 / kUnit) * problem.mesh.positions[v]), multigrid::Float4{}};
  steps.take(vectors);
  EXPECT_LT(steps.progress()[0].functional, 1e-9);
  EXPECT_GT(steps.progress()[0].decrease, 0.5);
  steps.set_residual(vectors);
  for (const multigrid::Row& b : vectors.b) {
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LT(std::abs(b.x[axis]), 1e-5);
      EXPECT_EQ(b.s[axis], 0);
    }
  }
}

}  // namespace
}  // namespace deltamesh
