// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The solver of highpass streams on a graph, anchors and numbers made from the input: a chain whose length
// the first byte sets, then pairs of bytes that add edges, anchors or deltas of any size. The solution's
// functional must come near that of the factorisation, unless it is refused, rounding alone can explain the
// difference, or positions are within a quarter of the errors to expect, as DELT-6 allows.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <span>
#include <vector>

#include "direct_solver/direct_solver.h"
#include "laplacian/solver.h"
#include "topology/adjacency.h"

namespace {

using namespace deltamesh;

struct Problem {
  Adjacency graph;
  std::vector<std::uint32_t> anchors;
  std::vector<Vec3> deltas;
  std::vector<Vec3> targets;
  double size = 1;  ///< largest number
};

Problem make_problem(std::span<const std::uint8_t> data) {
  Problem problem;
  const std::uint32_t count = 70 + 8U * data[0];
  std::vector<std::uint32_t> triangles;  // of an edge each
  const auto add_edge = [&](std::uint32_t a, std::uint32_t b) {
    triangles.insert(triangles.end(), {a, b, b});
  };
  for (std::uint32_t i = 0; i + 1 < count; ++i) add_edge(i, i + 1);
  problem.deltas.assign(count, Vec3{});
  problem.anchors = {0};
  for (std::size_t k = 1; k + 2 < data.size(); k += 3) {
    const std::uint32_t vertex = (data[k + 1] * 8U + data[k] % 8U) % count;
    const double value = std::ldexp(data[k + 2] - 128.0, (data[k] >> 3) - 16);
    switch (data[k] % 4) {
      case 0:
        add_edge(vertex, (vertex + 2 + data[k + 2] % 7U) % count);
        break;
      case 1:
        add_edge(vertex, (vertex + 37U * data[k + 2]) % count);
        break;
      case 2:
        problem.anchors.push_back(vertex);
        break;
      default:
        problem.deltas[vertex] = {value, -value, 0.5 * value};
        problem.size = std::max(problem.size, std::abs(value));
    }
  }
  std::sort(problem.anchors.begin(), problem.anchors.end());
  problem.anchors.erase(std::unique(problem.anchors.begin(), problem.anchors.end()), problem.anchors.end());
  for (const std::uint32_t anchor : problem.anchors) problem.targets.push_back({0.01 * anchor, 1, -1});
  problem.graph = build_adjacency(triangles, count);
  return problem;
}

double functional(const Problem& problem, std::span<const Vec3> x) {
  double sum = 0;
  for (std::uint32_t i = 0; i < x.size(); ++i) {
    Vec3 mean{};
    for (const std::uint32_t j : problem.graph.of(i)) mean = mean + x[j];
    const Vec3 residual = problem.deltas[i] - x[i] + (1.0 / problem.graph.degree(i)) * mean;
    sum += dot(residual, residual);
  }
  for (std::size_t a = 0; a < problem.anchors.size(); ++a) {
    const Vec3 gap = problem.targets[a] - x[problem.anchors[a]];
    sum += dot(gap, gap);
  }
  return sum;
}

std::vector<Vec3> solve_directly(const Problem& problem) {
  std::vector<Vec3> x(problem.deltas.size());
  test::DirectSolver(problem.graph, problem.anchors).solve(problem.deltas, problem.targets, x);
  return x;
}

double largest(std::span<const Vec3> x) {
  double result = 0;
  for (const Vec3& v : x) result = std::max(result, length(v));
  return result;
}

/// Root mean square, over vertices.
double rms(std::span<const Vec3> x) {
  double sum = 0;
  for (const Vec3& v : x) sum += dot(v, v);
  return std::sqrt(sum / static_cast<double>(x.size()));
}

double distance(std::span<const Vec3> x, std::span<const Vec3> y) {
  std::vector<Vec3> difference;
  for (std::size_t i = 0; i < x.size(); ++i) difference.push_back(x[i] - y[i]);
  return rms(difference);
}

/// Rms error of positions from random errors of deltas. `least`, the solution's functional, tells their size:
/// the system has 3 equations more than unknowns for each anchor.
double expected_error(Problem problem, double least) {
  constexpr int kTrials = 8;
  std::mt19937 random(1);
  std::fill(problem.targets.begin(), problem.targets.end(), Vec3{});
  double sum = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const auto sign = [&] { return random() % 2 == 0 ? 1.0 : -1.0; };
    for (Vec3& delta : problem.deltas) delta = {sign(), sign(), sign()};
    const double error = rms(solve_directly(problem));
    sum += error * error;
  }
  return std::sqrt(sum / kTrials * least / (3 * static_cast<double>(problem.anchors.size())));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const Problem problem = make_problem({data, size});
  std::vector<Vec3> x(problem.deltas.size());
  const Components components = find_components(problem.graph);
  LeastSquaresSolver solver(problem.graph, components);
  (void)solver.solve(problem.anchors, problem.deltas, problem.targets, 3, x);  // of which nothing is promised
  if (!solver.solve(problem.anchors, problem.deltas, problem.targets, 0, x))
    return 0;  // out of reach: refused
  const std::vector<Vec3> exact = solve_directly(problem);
  const double rounding = 1e-5 * (problem.size + largest(exact));
  const double least = functional(problem, exact);
  const double allowed = 4 * least + rounding * rounding * static_cast<double>(problem.deltas.size());
  if (functional(problem, x) <= allowed) return 0;
  if (!(distance(x, exact) <= 0.25 * expected_error(problem, least))) std::abort();
  return 0;
}
