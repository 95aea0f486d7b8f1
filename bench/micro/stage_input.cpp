// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "micro/stage_input.h"

#include <map>
#include <string>
#include <utility>

#include "laplacian/anchors/anchors.h"
#include "scenes.h"
#include "support/corpus.h"

namespace deltamesh::bench {
namespace {

constexpr std::uint64_t kSeed = 1;

StageInput make_input(Scene scene, std::uint64_t vertices) {
  StageInput input;
  input.mesh = value_or_exit(generate_scene(scene, vertices, kSeed));
  input.welded = welded_geometry(input.mesh);
  static_cast<WeldedMesh&>(input) = in_coding_order(weld(input.welded));
  return input;
}

}  // namespace

const StageInput& stage_input(benchmark::State& state) {
  static std::map<std::pair<std::int64_t, std::int64_t>, StageInput> inputs;
  const std::pair key{state.range(0), state.range(1)};
  const auto found = inputs.find(key);
  const auto scene = static_cast<Scene>(key.first);
  state.SetLabel(std::string(scene_names()[static_cast<std::size_t>(key.first)].name));
  if (found != inputs.end()) return found->second;
  return inputs.emplace(key, make_input(scene, static_cast<std::uint64_t>(key.second))).first->second;
}

Result<CodedHighpass> code_highpass(const StageInput& input) {
  AnchorSequence anchors(input.graph, input.components);
  HighpassCoder coder(input.graph, input.components, anchors, input.positions, input.box);
  return coder.code({.step = coder.step_for_bits(kDeltaBits), .anchors = anchors.most() / 200 + 1});
}

void use_scenes(benchmark::internal::Benchmark* benchmark) {
  for (const std::int64_t vertices : {4'000, 20'000})
    for (const Scene scene : {Scene::kRooms, Scene::kSphere, Scene::kCad})
      benchmark->Args({static_cast<std::int64_t>(scene), vertices});
  benchmark->ArgNames({"scene", "vertices"})->Unit(benchmark::kMillisecond);
}

void count_vertices(benchmark::State& state, const StageInput& input) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(input.vertex_count()));
}

}  // namespace deltamesh::bench
