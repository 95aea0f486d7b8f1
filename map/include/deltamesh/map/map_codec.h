// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Parts to bytes and back, by what their map's description says.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "deltamesh/decode.h"
#include "deltamesh/map/description.h"
#include "deltamesh/map/part.h"
#include "deltamesh/map/part_quality.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// Holds the description and the models that its primer leaves. Immutable; copies share their state, and
/// several threads may use one.
class MapCodec {
 public:
  /// Decodes the primer. Errors: kInvalidArgument, those of decode() for the primer, kOutOfMemory.
  static Result<MapCodec> open(MapDescription description, const DecodeLimits& limits = {}) noexcept;

  const MapDescription& description() const noexcept;

  /// The same part and quality give the same bytes. Errors: kInvalidMesh (a mesh without the map's
  /// attributes, positions off the lattice's range), kUnmetRequest, kLimitExceeded (more than kMostPartBytes:
  /// split it), kOutOfMemory.
  Result<CodedPart> encode(const MapPart& part, const PartQuality& quality = {}) const noexcept;

  /// Bytes are not trusted: memory is bounded by a constant times their number plus `limits`. Errors: 1xx
  /// codes (kCorrupt also where the bytes are those of another part, map or epoch), kLimitExceeded,
  /// kOutOfMemory.
  Result<MapPart> decode(const PartKey& key, std::span<const std::byte> bytes,
                         const DecodeOptions& options = {}) const noexcept;

  struct State;  ///< src/codec_state.h; not for callers
  const State& state() const noexcept { return *state_; }

 private:
  explicit MapCodec(std::shared_ptr<const State> state) noexcept;
  std::shared_ptr<const State> state_;
};

/// `description` with primers for parts of this quality: of the largest of `parts` those that pay, up to 16
/// KB of them or one; a single part always, as it costs nothing and parts to come learn from it. Cost:
/// encodes a sample of the parts several times. Errors: as MapCodec::encode().
Result<MapDescription> with_primers(MapDescription description, std::span<const MapPart> parts,
                                    const PartQuality& quality = {}) noexcept;

}  // namespace deltamesh
