// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Octets of parts, and patches of parts, to meshes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "deltamesh/decode.h"
#include "deltamesh/map/part.h"
#include "deltamesh/result.h"
#include "part/codec_state.h"

namespace deltamesh {

/// As MapCodec::decode().
Result<MapPart> decode_part(const MapCodec::State& state, const PartKey& key,
                            std::span<const std::byte> octets, const DecodeOptions& options);

/// The part `key` that a patch makes of `base`, whose octets have the hash `base_hash` [MAP-17]. Errors: as
/// decode_part().
Result<MapPart> apply_patch(const MapCodec::State& state, const PartKey& key, const MapPart& base,
                            std::uint64_t base_hash, std::span<const std::byte> body,
                            const DecodeOptions& options);

}  // namespace deltamesh
