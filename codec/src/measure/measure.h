// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The paper's two error figures and the largest one, over position-welded vertices that a face uses.
#pragma once

#include <span>

#include "base/numbers/vec3.h"
#include "deltamesh/stream_info.h"
#include "topology/adjacency.h"
#include "topology/mesh_edges.h"

namespace deltamesh {

/// `original`, `decoded`: n each, same order; `graph`: of the welded faces. Vertices without neighbours are
/// left out of VDE and LFE but count for the maximum. Edge lengths are each mesh's own, not below 1e-9 of the
/// diagonal of `original`'s box (eqs. 1, 2).
Quality measure_quality(const Adjacency& graph, std::span<const Vec3> original,
                        std::span<const Vec3> decoded);

/// VDE alone, the edges being known.
double measure_vde(const MeshEdges& edges, std::span<const Vec3> original, std::span<const Vec3> decoded);

}  // namespace deltamesh
