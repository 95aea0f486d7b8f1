// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The pairs of an octree's transform (RAHT, as G-PCC has it) in place of those over the mesh. Source: de
// Queiroz, Chou 2016, "Compression of 3D Point Clouds Using a Region-Adaptive Hierarchical Transform".
#pragma once

#include <vector>

#include "attributes/haar/levels/levels.h"

namespace deltamesh::bench {

enum class OctreePrediction : bool { kNone, kFromNeighbors };

/// Joins halves of cells along z, y, x, from the smallest cells up; what lies in one place is joined before.
/// kNone: no node has neighbours, so that nothing is predicted. O(n log n) each of 60 bits.
std::vector<HaarLevel> make_octree_levels(const AttributeSurface& surface, OctreePrediction prediction);

}  // namespace deltamesh::bench
