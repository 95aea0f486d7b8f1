// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A part as octets, with what receivers decode.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/map/part.h"
#include "deltamesh/map/part_quality.h"
#include "deltamesh/result.h"
#include "part/codec_state.h"

namespace deltamesh {

struct DecodedPart {
  CodedPart coded;
  MapPart part;                      ///< as MapCodec::decode() gives it
  std::vector<std::uint32_t> order;  ///< the source's vertex for each of its vertices
  bool is_grid = false;              ///< its stream has faces in cubes
};

/// What a part is made for [MAP-17].
struct PartUse {
  const MapPart* base = nullptr;  ///< decoded, which the part is coded beside
  /// Or, of what is inserted into a base, 1 for vertices that are joined to the base's, of which no error
  /// counts, else 0.
  std::span<const std::uint8_t> is_joined{};
};

/// As MapCodec::encode().
Result<DecodedPart> encode_part(const MapCodec::State& state, const MapPart& part, const PartQuality& quality,
                                const PartUse& use = {});

}  // namespace deltamesh
