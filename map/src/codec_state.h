// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a MapCodec holds.
#pragma once

#include <cstdint>

#include "border_coder.h"
#include "deltamesh/map/map_codec.h"
#include "part_container.h"

namespace deltamesh {

struct MapCodec::State {
  MapDescription description;
  std::uint64_t description_hash = 0;
  BorderModels border{};

  PartPlace place_of(const PartKey& key) const noexcept { return {description, description_hash, key}; }
};

}  // namespace deltamesh
