// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Derives the description of a map from the request.
#pragma once

#include <span>

#include "base/numbers/vec3.h"
#include "deltamesh/map/encode_map.h"

namespace deltamesh {

inline constexpr std::uint8_t kLevelsOfParts = 3;  ///< from the smallest to the largest

/// Bounding box of `positions`, n x 3; all 0 if there are none.
Box box_of(std::span<const float> positions) noexcept;

/// Bounds in model units, or those that encode() has for the whole mesh.
QualityRequest request_of(const MeshView& mesh, const QualityRequest& asked);

/// Of a map that begins with `mesh`, without primers. `grid`: that the mesh was cut from, if any. `request`:
/// in model units, not empty. `finer`: how often the lattice's step is half of what suits it. Errors:
/// kInvalidArgument.
Result<MapDescription> describe_map(const MeshView& mesh, const std::optional<VoxelGrid>& grid,
                                    const MapSettings& settings, const QualityRequest& request, int finer);

}  // namespace deltamesh
