// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Quality of positions on a lattice.
#pragma once

#include <span>

#include "base/numbers/vec3.h"
#include "deltamesh/stream_info.h"
#include "format/predictive_parameters.h"
#include "positions/blend/blend.h"
#include "topology/mesh_edges.h"

namespace deltamesh {

/// LFE and the largest error; not finite where a decoder would not give floats. `positions`, `cells`: n.
/// O(n).
Quality positional_quality(std::span<const Vec3> positions, std::span<const Cell> cells,
                           const PositionLattice& lattice, const MeshEdges& edges) noexcept;

/// VDE, rms. O(n + edges).
double visual_error(const MeshEdges& edges, std::span<const Vec3> positions, std::span<const Cell> cells,
                    const PositionLattice& lattice);

}  // namespace deltamesh
