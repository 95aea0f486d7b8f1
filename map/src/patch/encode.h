// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A newer source as a patch of the version that a receiver has [MAP-17].
#pragma once

#include <cstdint>
#include <optional>

#include "deltamesh/map/part.h"
#include "deltamesh/map/part_quality.h"
#include "deltamesh/result.h"
#include "part/codec_state.h"
#include "part/encode.h"
#include "patch/match.h"

namespace deltamesh {

/// The whole of `source` beside `base`. The result's bytes are the patch alone. Empty where the part is in no
/// grid, so that the base is of no use. Errors: as MapCodec::encode().
Result<std::optional<DecodedPart>> encode_beside(const MapCodec::State& state, const MapPart& source,
                                                 const MapPart& base, std::uint64_t base_hash,
                                                 const PartQuality& quality);

/// A plan and what is inserted. `match`: what match_part() gave for `source` and `base`, whose octets have
/// the hash `base_hash`. The result's bytes are the patch alone. Empty where the receiver's part would be
/// beyond the quality. Errors: as MapCodec::encode().
Result<std::optional<DecodedPart>> encode_patch(const MapCodec::State& state, const MapPart& source,
                                                const BaseVersion& base, std::uint64_t base_hash,
                                                const PartMatch& match, const PartQuality& quality);

}  // namespace deltamesh
