// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A part as octets, with what receivers decode.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/known_mesh.h"
#include "deltamesh/map/part.h"
#include "deltamesh/map/part_quality.h"
#include "deltamesh/result.h"
#include "part/codec_state.h"

namespace deltamesh {

struct DecodedPart {
  CodedPart coded;
  MapPart part;                      ///< as MapCodec::decode() gives it
  std::vector<std::uint32_t> order;  ///< the source's vertex for each of its vertices
};

/// What the part is added to.
struct JoinedTo {
  KnownMesh mesh;                           ///< the base [MAP-17]
  std::span<const std::uint8_t> is_joined;  ///< 1 for vertices of the part that are vertices of that, else 0
};

/// As MapCodec::encode(). `joined`: null for a part that is whole. Of vertices that are joined no error
/// counts.
Result<DecodedPart> encode_part(const MapCodec::State& state, const MapPart& part, const PartQuality& quality,
                                const JoinedTo* joined = nullptr);

}  // namespace deltamesh
