// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/map/map_codec.h"

#include <utility>

#include "base/guard.h"
#include "base/try.h"
#include "lattice/border_payload.h"
#include "part/codec_state.h"
#include "patch/part_or_patch.h"

namespace deltamesh {
namespace {

/// Adds the models after the next primer.
Result<void> learn(const MapPrimer& primer, const DecodeLimits& limits, MapCodec::State& state) {
  const CodecModels& before = state.models.back();
  const DecodeOptions options{.limits = limits, .starting_states = before.start()};
  CodecModels after;
  DELTAMESH_TRY(after.streams, ModelStates::learn(primer.stream, options));
  DELTAMESH_TRY(Mesh mesh, decode(primer.stream, options));
  DELTAMESH_TRY(const BorderView view, view_border(primer.stream, mesh, state.description.lattice));
  DELTAMESH_TRY([[maybe_unused]] const auto border,
                read_border(primer.border, mesh, view, {&before.border, &after.border}));
  after.border.limit_counts(kMostCountedBefore);
  DELTAMESH_TRY(StreamInfo info, inspect(primer.stream));
  state.primers.push_back(std::move(info));
  state.models.push_back(std::move(after));
  return {};
}

}  // namespace

MapCodec::MapCodec(std::shared_ptr<const State> state) noexcept : state_(std::move(state)) {}

const MapDescription& MapCodec::description() const noexcept { return state_->description; }

Result<MapCodec> MapCodec::open(MapDescription description, const DecodeLimits& limits) noexcept {
  return guarded([&]() -> Result<MapCodec> {
    DELTAMESH_CHECK(validate(description));
    auto state = std::make_shared<State>();
    state->description = std::move(description);
    state->description_hash = hash_of(state->description);
    for (const MapPrimer& primer : state->description.primers) DELTAMESH_CHECK(learn(primer, limits, *state));
    return MapCodec(std::move(state));
  });
}

Result<MapPart> MapCodec::decode(const PartKey& key, std::span<const std::byte> bytes,
                                 const DecodeOptions& options) const noexcept {
  return guarded([&] { return decode_part(*state_, key, bytes, options); });
}

}  // namespace deltamesh
