// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "connectivity/faces/faces.h"
#include "micro/stage_input.h"
#include "topology/weld.h"

namespace deltamesh::bench {
namespace {

void weld_positions(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  const std::vector<std::uint8_t> welds(input.mesh.vertex_count(), 1);
  for (auto _ : state) benchmark::DoNotOptimize(weld_by_position(input.mesh.positions, welds));
  count_vertices(state, input);
}
BENCHMARK(weld_positions)->Apply(use_scenes);

void adjacency(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  for (auto _ : state) benchmark::DoNotOptimize(build_adjacency(input.triangles, input.vertex_count()));
  count_vertices(state, input);
}
BENCHMARK(adjacency)->Apply(use_scenes);

void components(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  for (auto _ : state) benchmark::DoNotOptimize(find_components(input.graph));
  count_vertices(state, input);
}
BENCHMARK(components)->Apply(use_scenes);

void connectivity_write(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  for (auto _ : state) benchmark::DoNotOptimize(write_connectivity(input.triangles, input.vertex_count()));
  count_vertices(state, input);
}
BENCHMARK(connectivity_write)->Apply(use_scenes);

void connectivity_read(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  const auto coded = write_connectivity(input.triangles, input.vertex_count());
  const auto faces = static_cast<std::uint32_t>(input.triangles.size() / 3);
  for (auto _ : state)
    benchmark::DoNotOptimize(value_or_exit(read_connectivity(coded.payload, input.vertex_count(), faces)));
  count_vertices(state, input);
}
BENCHMARK(connectivity_read)->Apply(use_scenes);

}  // namespace
}  // namespace deltamesh::bench
