// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// State of a MapCodec.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "deltamesh/map/map_codec.h"
#include "deltamesh/model_states.h"
#include "lattice/border_coder.h"
#include "part/container.h"

namespace deltamesh {

/// Models that coders start from.
struct CodecModels {
  std::optional<ModelStates> streams{};  ///< empty: fresh models
  BorderModels border{};

  const ModelStates* start() const noexcept { return streams ? &*streams : nullptr; }
};

struct MapCodec::State {
  MapDescription description;
  std::uint64_t description_hash = 0;
  /// Before each primer, and after the last one: without primers fresh models, once.
  std::vector<CodecModels> models = std::vector<CodecModels>(1);
  std::vector<StreamInfo> primers{};  ///< what they say of themselves

  /// `base`: that the part is coded beside, if any.
  PartPlace place_of(const PartKey& key, const MapPart* base = nullptr) const noexcept {
    const std::size_t known = base != nullptr ? base->mesh.vertex_count() + base->mesh.triangle_count() : 0;
    return {description, description_hash, key, known};
  }
};

}  // namespace deltamesh
