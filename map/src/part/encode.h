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

/// What a part is made for [MAP-17]; one of both at most.
struct PartUse {
  const MapPart* base = nullptr;  ///< the decoded base that it is coded beside
  /// Of what is inserted by a plan: 1 for every vertex that one of the base takes the place of, whose error
  /// does not count, else 0.
  std::span<const std::uint8_t> is_joined{};
};

/// As MapCodec::encode().
Result<DecodedPart> encode_part(const MapCodec::State& state, const MapPart& part, const PartQuality& quality,
                                const PartUse& use = {});

}  // namespace deltamesh
