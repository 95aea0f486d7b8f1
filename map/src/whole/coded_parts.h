// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Parts as octets, with what a manifest says of them.
#pragma once

#include <span>

#include "deltamesh/map/encode_map.h"
#include "deltamesh/map/map_codec.h"

namespace deltamesh {

/// `quality`: in model units; coarser copies are coded within half of their simplification's error where
/// that is more. Entries without revision, group and links. Of parts that are not among `finest`, which are
/// coarser copies, the largest error is that to the faces of `finest` in their cells [MAP-19]. All ascending
/// by key. Errors: as MapCodec::encode().
Result<MapState> code_parts(const MapCodec& codec, std::span<const MapPart> parts,
                            std::span<const MapPart> finest, const PartQuality& quality);

}  // namespace deltamesh
