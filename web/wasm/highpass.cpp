// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The solver's exports.
#include "highpass/highpass.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "part.h"

namespace deltamesh::web {
namespace {

LargeVector<Vec3> positions;
PartOutcome outcome;

Payload payload_of(std::span<const std::byte> bytes, std::uint32_t is_compact) {
  return is_compact != 0 ? Payload::compact(bytes) : Payload(bytes);
}

}  // namespace

extern "C" {

/// Releases `call` and its arrays. The outcome lives until the next call, or until forget().
DELTAMESH_EXPORT(call) PartOutcome* call(HighpassCall* handed) {
  const HighpassCall call = *handed;
  release(handed);
  const auto deltas = take_array<LargeVector<std::byte>>(call.deltas);
  const auto anchors = take_array<LargeVector<std::byte>>(call.anchors);
  Adjacency graph{.offsets = take_array<LargeVector<std::uint32_t>>(call.offsets),
                  .neighbors = take_array<LargeVector<std::uint32_t>>(call.neighbors)};
  Components components{.label = take_array<LargeVector<std::uint32_t>>(call.labels),
                        .size = take_array<std::vector<std::uint32_t>>(call.sizes)};
  components.count = static_cast<std::uint32_t>(components.size.size());
  auto solved = read_highpass(payload_of(deltas, call.deltas_are_compact),
                              payload_of(anchors, call.anchors_are_compact), std::move(graph),
                              std::move(components), call.box, call.parameters);
  outcome = {};
  if (solved) {
    positions = *std::move(solved);
    outcome.returned.add(positions);
  } else {
    outcome.error = outcome_of(solved.error());
  }
  return &outcome;
}

DELTAMESH_EXPORT(forget) void forget() { positions = {}; }

}  // extern "C"
}  // namespace deltamesh::web
