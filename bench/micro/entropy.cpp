// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Chunks of the compact coder one by one, and the whole of Draco at level 7 beside them.
#include <span>
#include <vector>

#include "connectivity/faces/faces.h"
#include "highpass/compact.h"
#include "laplacian/operator/solved_part.h"
#include "micro/stage_input.h"
#include "peers/peer.h"

namespace deltamesh::bench {
namespace {

/// Also reports the size of what is coded.
template <class Work>
void run(benchmark::State& state, const StageInput& input, std::size_t bytes, Work work) {
  for (auto _ : state) benchmark::DoNotOptimize(work());
  count_vertices(state, input);
  state.counters["bits_per_vertex"] = 8 * static_cast<double>(bytes) / input.vertex_count();
}

void connectivity_write(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  const auto write = [&] { return write_connectivity(input.welded.triangles, input.vertex_count()); };
  run(state, input, write().payload.size(), write);
}
BENCHMARK(connectivity_write)->Apply(use_scenes);

void connectivity_read(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  const auto coded = write_connectivity(input.welded.triangles, input.vertex_count());
  const auto faces = static_cast<std::uint32_t>(input.welded.triangle_count());
  run(state, input, coded.payload.size(),
      [&] { return value_or_exit(read_connectivity(coded.payload, input.vertex_count(), faces)); });
}
BENCHMARK(connectivity_read)->Apply(use_scenes);

void deltas_write(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  const SolvedPart part = extract_solved_part(input.graph, input.components);
  const auto bytes = value_or_exit(code_highpass(input)).deltas;
  const auto deltas = value_or_exit(read_compact_deltas(bytes, part.graph));
  run(state, input, bytes.size(), [&] { return write_compact_deltas(deltas, part.graph); });
}
BENCHMARK(deltas_write)->Apply(use_scenes);

void deltas_read(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  const SolvedPart part = extract_solved_part(input.graph, input.components);
  const auto bytes = value_or_exit(code_highpass(input)).deltas;
  run(state, input, bytes.size(), [&] { return value_or_exit(read_compact_deltas(bytes, part.graph)); });
}
BENCHMARK(deltas_read)->Apply(use_scenes);

void anchors_write(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  const CodedHighpass coded = value_or_exit(code_highpass(input));
  const auto list = value_or_exit(read_anchors(coded.anchors, coded.parameters.anchors));
  run(state, input, coded.anchors.size(), [&] { return write_compact_anchors(list); });
}
BENCHMARK(anchors_write)->Apply(use_scenes);

void anchors_read(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  const CodedHighpass coded = value_or_exit(code_highpass(input));
  run(state, input, coded.anchors.size(),
      [&] { return value_or_exit(read_anchors(coded.anchors, coded.parameters.anchors)); });
}
BENCHMARK(anchors_read)->Apply(use_scenes);

void draco_encode(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  const auto peer = make_draco_peer(7, 11);
  check_or_exit(peer->load(input.welded));
  run(state, input, value_or_exit(peer->encode()).size(), [&] { return value_or_exit(peer->encode()); });
}
BENCHMARK(draco_encode)->Apply(use_scenes);

void draco_decode(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  const auto peer = make_draco_peer(7, 11);
  check_or_exit(peer->load(input.welded));
  const auto bytes = value_or_exit(peer->encode());
  run(state, input, bytes.size(), [&] { return peer->decode(bytes).has_value(); });
}
BENCHMARK(draco_decode)->Apply(use_scenes);

}  // namespace
}  // namespace deltamesh::bench
