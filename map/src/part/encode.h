// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A part as octets, with what receivers decode.
#pragma once

#include <cstdint>
#include <vector>

#include "deltamesh/map/part.h"
#include "deltamesh/result.h"
#include "part/codec_state.h"

namespace deltamesh {

struct DecodedPart {
  CodedPart coded;
  MapPart part;                      ///< as MapCodec::decode() gives it
  std::vector<std::uint32_t> order;  ///< the source's vertex for each of its vertices
};

/// As MapCodec::encode().
Result<DecodedPart> encode_part(const MapCodec::State& state, const MapPart& part,
                                const PartQuality& quality);

}  // namespace deltamesh
