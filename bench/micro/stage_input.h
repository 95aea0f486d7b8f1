// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What the stages of the codec get to chew on: generated scenes, taken to the form that inner stages take.
#pragma once

#include <benchmark/benchmark.h>

#include <cstdint>

#include "deltamesh/mesh.h"
#include "highpass/highpass.h"
#include "support/errors.h"
#include "support/welded_mesh.h"

namespace deltamesh::bench {

/// In coding order.
struct StageInput : WeldedMesh {
  Mesh mesh;    ///< as generated
  Mesh welded;  ///< in the order of that

  std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(positions.size()); }
};

/// The scene that `state`'s first argument names and the size its second asks for; made once per program.
/// Ends the program where a scene cannot be generated.
const StageInput& stage_input(benchmark::State& state);

/// Highpass streams at kDeltaBits, and at the default share of anchors.
Result<CodedHighpass> code_highpass(const StageInput& input);
inline constexpr int kDeltaBits = 8;

/// Registers rooms, sphere and cad at 4,000 and 20,000 vertices.
void use_scenes(benchmark::internal::Benchmark* benchmark);

/// Reports the speed as vertices per second.
void count_vertices(benchmark::State& state, const StageInput& input);

}  // namespace deltamesh::bench
