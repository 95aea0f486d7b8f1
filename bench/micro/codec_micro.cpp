// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <cstddef>
#include <vector>

#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "entropy/code_chunk.h"
#include "entropy/expand_chunk.h"
#include "format/tags.h"
#include "micro/stage_input.h"

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

Encoded zstd_stream(const Mesh& mesh) {
  EncodeOptions options;
  options.profile = Profile::kZstd;
  return value_or_exit(encode(mesh, options));
}

/// The zstd stage on the positions of a stream of profile zstd, both ways.
void zstd_code(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  const auto encoded = zstd_stream(input.mesh);
  const auto container = value_or_exit(Container::open(encoded.bytes));
  const auto chunk = value_or_exit(expand_single(container, kTagPositions));
  const std::vector<std::byte> payload(chunk.bytes().begin(), chunk.bytes().end());
  for (auto _ : state) benchmark::DoNotOptimize(code_plain_chunk(kTagPositions, payload));
  count_vertices(state, input);
}
BENCHMARK(zstd_code)->Apply(use_scenes);

void zstd_expand(benchmark::State& state) {
  const StageInput& input = stage_input(state);
  const auto encoded = zstd_stream(input.mesh);
  const auto container = value_or_exit(Container::open(encoded.bytes));
  for (auto _ : state) benchmark::DoNotOptimize(value_or_exit(expand_single(container, kTagPositions)));
  count_vertices(state, input);
}
BENCHMARK(zstd_expand)->Apply(use_scenes);

}  // namespace
}  // namespace deltamesh::bench
