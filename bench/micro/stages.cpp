// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The stages from a mesh to its stream and back, but for the entropy coder.
#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "highpass/highpass.h"
#include "laplacian/anchors/anchor_sequence.h"
#include "measure/measure.h"
#include "micro/stage_input.h"
#include "topology/weld.h"

namespace deltamesh::bench {
namespace {

void encode_mesh(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  for (auto _ : state) benchmark::DoNotOptimize(value_or_exit(encode(input.mesh)));
  count_vertices(state, input);
}
BENCHMARK(encode_mesh)->Apply(use_scenes);

void decode_mesh(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  const auto encoded = value_or_exit(encode(input.mesh));
  for (auto _ : state) benchmark::DoNotOptimize(value_or_exit(decode(encoded.bytes)));
  count_vertices(state, input);
}
BENCHMARK(decode_mesh)->Apply(use_scenes);

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

void highpass_write(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  for (auto _ : state) benchmark::DoNotOptimize(value_or_exit(code_highpass(input)));
  count_vertices(state, input);
}
BENCHMARK(highpass_write)->Apply(use_scenes);

void highpass_read(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  const auto coded = value_or_exit(code_highpass(input));
  for (auto _ : state)
    benchmark::DoNotOptimize(value_or_exit(read_highpass(coded.deltas, coded.anchors, input.graph,
                                                         input.components, input.box, coded.parameters)));
  count_vertices(state, input);
}
BENCHMARK(highpass_read)->Apply(use_scenes);

void quality(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  const auto coded = value_or_exit(code_highpass(input));
  for (auto _ : state)
    benchmark::DoNotOptimize(measure_quality(input.graph, input.positions, coded.positions));
  count_vertices(state, input);
}
BENCHMARK(quality)->Apply(use_scenes);

}  // namespace
}  // namespace deltamesh::bench
