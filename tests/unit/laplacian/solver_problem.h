// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Least-squares problems as streams have them, and what solvers make of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "direct_solver/direct_solver.h"
#include "laplacian/operator/delta.h"
#include "laplacian/solver.h"
#include "support/graph_mesh.h"

namespace deltamesh::test {

struct SolverProblem {
  GraphMesh mesh;
  std::vector<std::uint32_t> anchors;
  std::vector<Vec3> deltas;
  std::vector<Vec3> targets;
  double step = 0;  ///< that deltas are multiples of; 0 where they are not
};

inline Vec3 round_to(const Vec3& v, double step) {
  return {step * std::round(v[0] / step), step * std::round(v[1] / step), step * std::round(v[2] / step)};
}

/// Quantised as a stream of `bits` is.
inline SolverProblem quantized(GraphMesh mesh, std::uint32_t anchors, int bits) {
  SolverProblem problem{std::move(mesh), {}, {}, {}, 0};
  const GraphMesh& m = problem.mesh;
  problem.anchors = anchors_of(m, anchors);
  problem.deltas = delta_coordinates(m.graph, m.positions);
  problem.step = std::ldexp(delta_range(problem.deltas), -bits);
  for (Vec3& delta : problem.deltas) delta = round_to(delta, problem.step);
  for (const std::uint32_t anchor : problem.anchors)
    problem.targets.push_back(round_to(m.positions[anchor], m.box.longest_side() / 4095));
  return problem;
}

inline PlannedSolver solver_for(const SolverProblem& problem) {
  return PlannedSolver(problem.mesh.graph, problem.mesh.components);
}

inline std::vector<Vec3> solve_directly(const SolverProblem& problem) {
  std::vector<Vec3> x(problem.mesh.positions.size());
  DirectSolver(problem.mesh.graph, problem.anchors).solve(problem.deltas, problem.targets, x);
  return x;
}

struct Errors {
  double rms = 0;
  double largest = 0;
};

inline Errors errors(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  Errors result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec3 difference = a[i] - b[i];
    result.rms += dot(difference, difference) / static_cast<double>(a.size());
    result.largest = std::max(result.largest, length(difference));
  }
  result.rms = std::sqrt(result.rms);
  return result;
}

inline GraphMesh many_sheets() {
  GraphMesh mesh;
  add_sheet(mesh, 90, 80, {});
  for (std::uint32_t i = 0; i < 60; ++i)
    add_sheet(mesh, 4 + i % 17, 2 + i / 4, {100.0 + 25 * (i % 8), 20.0 * (i / 8), 3});
  return finish(std::move(mesh));
}

}  // namespace deltamesh::test
