// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The solver of highpass streams on a graph, anchors and numbers made from the input: a chain whose length
// the first byte sets, then pairs of bytes that add edges, anchors or deltas of any size. The solutions of
// graphs with few vertices are those of the factorisation, as far as rounding lets them.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "direct_solver/direct_solver.h"
#include "goal.h"
#include "laplacian/solver.h"
#include "topology/adjacency.h"

namespace {

using namespace deltamesh;

fuzz::Goal solved_directly("a problem of few vertices");
fuzz::Goal solved_by_cycles("a problem of many vertices");

struct Problem {
  Adjacency graph;
  std::vector<std::uint32_t> anchors;
  std::vector<Vec3> deltas;
  std::vector<Vec3> targets;
  double size = 1;  ///< largest number
};

Problem make_problem(std::span<const std::uint8_t> data) {
  Problem problem;
  const std::uint32_t count = 70 + 2U * data[0];
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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const Problem problem = make_problem({data, size});
  std::vector<Vec3> x(problem.deltas.size());
  const Components components = find_components(problem.graph);
  PlannedSolver solver(problem.graph, components);
  const bool solved = solver.solve(problem.anchors, problem.deltas, problem.targets, 3, x).has_value();
  if (x.size() >= 200) {  // by cycles, of which nothing is promised
    if (solved) solved_by_cycles.reach();
    return 0;
  }
  if (!solved) std::abort();
  const std::vector<Vec3> exact = solve_directly(problem);
  const double rounding = 1e-5 * (problem.size + largest(exact));
  const double allowed =
      4 * functional(problem, exact) + rounding * rounding * static_cast<double>(problem.deltas.size());
  if (!(functional(problem, x) <= allowed)) std::abort();
  solved_directly.reach();
  return 0;
}
