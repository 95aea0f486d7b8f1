// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A part as a primer.
#pragma once

#include "deltamesh/map/map_codec.h"

namespace deltamesh {

/// `part` as the primer that follows those of the codec's description. Errors: as MapCodec::encode().
Result<MapPrimer> make_primer(const MapCodec& codec, const MapPart& part, const PartQuality& quality);

}  // namespace deltamesh
