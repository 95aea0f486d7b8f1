// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// read_highpass() for `core`: the module `highpass` does it.
#include <span>

#include "geometry/highpass.h"
#include "highpass_call.h"
#include "runtime.h"

extern "C" {
/// Copies bytes into the memory of `highpass`; returns their address there.
DELTAMESH_IMPORT(give) std::uint32_t give(const void* from, std::size_t bytes);
/// Makes the call at that address; 0, or the code of an error that JavaScript keeps.
DELTAMESH_IMPORT(solve) std::uint32_t solve(std::uint32_t call);
/// Copies the positions of the last call, and lets go of them.
DELTAMESH_IMPORT(take) void take(void* to, std::size_t bytes);
}

namespace deltamesh {
namespace {

template <class Array>
web::HandedArray hand_over(const Array& array) {
  const auto bytes = std::as_bytes(std::span(array));
  return {.address = give(bytes.data(), bytes.size()), .bytes = static_cast<std::uint32_t>(bytes.size())};
}

}  // namespace

Result<LargeVector<Vec3>> read_highpass(Payload deltas, Payload anchors, Adjacency graph,
                                        Components components, const Box& box,
                                        const HighpassParameters& parameters, ThreadTeam*) {
  const std::size_t vertex_count = graph.vertex_count();
  web::HighpassCall call{.box = box, .parameters = parameters};
  call.deltas = hand_over(deltas.bytes);
  call.anchors = hand_over(anchors.bytes);
  call.deltas_are_compact = deltas.is_compact;
  call.anchors_are_compact = anchors.is_compact;
  call.offsets = hand_over(graph.offsets);
  call.neighbors = hand_over(graph.neighbors);
  graph = {};
  call.labels = hand_over(components.label);
  call.sizes = hand_over(components.size);
  components = {};
  if (const std::uint32_t code = solve(give(&call, sizeof(call))); code != 0)
    return Error{.code = static_cast<ErrorCode>(code)};
  LargeVector<Vec3> positions(vertex_count);
  take(positions.data(), vertex_count * sizeof(Vec3));
  return positions;
}

}  // namespace deltamesh
