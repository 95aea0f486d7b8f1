// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <cmath>

#include "direct_solver/direct_solver.h"
#include "highpass/highpass.h"
#include "laplacian/anchors/anchors.h"
#include "laplacian/operator/delta.h"
#include "laplacian/operator/solved_part.h"
#include "measure/measure.h"
#include "micro/stage_input.h"

namespace deltamesh::bench {
namespace {

constexpr int kBits = 8;

/// The solver's problem at the default share of anchors.
struct SolverProblem {
  SolvedPart part;
  std::vector<Vec3> deltas;
  std::vector<std::uint32_t> anchors;
  std::vector<Vec3> anchor_positions;
};

SolverProblem make_problem(const StageInput& input) {
  SolverProblem problem;
  problem.part = extract_solved_part(input.graph, input.components);
  std::vector<Vec3> positions;
  for (std::size_t row = 0; row < problem.part.row_count; ++row)
    positions.push_back(input.positions[problem.part.vertex(row)]);
  problem.deltas = delta_coordinates(problem.part.graph, positions);
  const Components components = find_components(problem.part.graph);
  const auto count = static_cast<std::uint32_t>(positions.size() / 200 + 1);
  problem.anchors = AnchorSequence(problem.part.graph, components).first(problem.part.graph, count).vertices;
  for (const std::uint32_t row : problem.anchors) problem.anchor_positions.push_back(positions[row]);
  return problem;
}

/// At the default share of anchors.
Result<CodedHighpass> code(const StageInput& input) {
  AnchorSequence anchors(input.graph, input.components);
  HighpassCoder coder(input.graph, input.components, anchors, input.positions, input.box);
  return coder.code({.step = coder.step_for_bits(kBits), .anchors = default_anchor_count(anchors.most())});
}

void delta_quantize(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  const double step = delta_range(delta_coordinates(input.graph, input.positions)) / (1 << kBits);
  std::vector<std::int32_t> symbols(3 * input.positions.size());
  for (auto _ : state) {
    const auto deltas = delta_coordinates(input.graph, input.positions);
    for (std::size_t i = 0; i < symbols.size(); ++i)
      symbols[i] = static_cast<std::int32_t>(std::round(deltas[i / 3][i % 3] / step));
    benchmark::DoNotOptimize(symbols.data());
    benchmark::ClobberMemory();
  }
  count_vertices(state, input);
}
BENCHMARK(delta_quantize)->Apply(use_scenes);

void anchor_placement(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  const std::uint32_t count = input.vertex_count() / 200 + 1;
  for (auto _ : state) {
    AnchorSequence anchors(input.graph, input.components);
    benchmark::DoNotOptimize(anchors.first(input.graph, count));
  }
  count_vertices(state, input);
}
BENCHMARK(anchor_placement)->Apply(use_scenes);

void solver_setup(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  const SolverProblem problem = make_problem(input);
  for (auto _ : state) benchmark::DoNotOptimize(test::DirectSolver(problem.part.graph, problem.anchors));
  count_vertices(state, input);
}
BENCHMARK(solver_setup)->Apply(use_scenes);

void solver_solve(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  const SolverProblem problem = make_problem(input);
  const test::DirectSolver solver(problem.part.graph, problem.anchors);
  std::vector<Vec3> x(problem.deltas.size());
  for (auto _ : state) {
    solver.solve(problem.deltas, problem.anchor_positions, x);
    benchmark::DoNotOptimize(x.data());
    benchmark::ClobberMemory();
  }
  count_vertices(state, input);
}
BENCHMARK(solver_solve)->Apply(use_scenes);

void highpass_write(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  for (auto _ : state) benchmark::DoNotOptimize(value_or_exit(code(input)));
  count_vertices(state, input);
}
BENCHMARK(highpass_write)->Apply(use_scenes);

void highpass_read(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  const auto coded = value_or_exit(code(input));
  for (auto _ : state)
    benchmark::DoNotOptimize(value_or_exit(read_highpass(coded.deltas, coded.anchors, input.graph,
                                                         input.components, input.box, coded.parameters)));
  count_vertices(state, input);
}
BENCHMARK(highpass_read)->Apply(use_scenes);

void quality(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  const auto coded = value_or_exit(code(input));
  for (auto _ : state)
    benchmark::DoNotOptimize(measure_quality(input.graph, input.positions, coded.positions));
  count_vertices(state, input);
}
BENCHMARK(quality)->Apply(use_scenes);

}  // namespace
}  // namespace deltamesh::bench
