// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The source of one cell of level 0, as a splitter keeps it.
#pragma once

#include <array>
#include <cstdint>
#include <map>

#include "deltamesh/map/description.h"
#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// A cell of level 0: x, y, z, the order in which blocks come in a part.
using Cell0 = std::array<std::int32_t, 3>;

struct StoredBlock {
  Mesh mesh;               ///< positions relative to the map's origin, one zero, every vertex used
  std::uint64_t hash = 0;  ///< of all that
};
using StoredBlocks = std::map<Cell0, StoredBlock>;

/// `mesh` with positions relative to the map's origin and only those vertices that a face uses. Errors:
/// kInvalidMesh (not a mesh, without the map's attributes), kUnmetRequest (the lattice is too fine to reach a
/// position), kNotFinite.
Result<Mesh> to_map(const MeshView& mesh, const MapDescription& description);

/// The faces of `mesh`, which to_map() gave, by the cells that their centroids are in [MAP-4]. O(n log n).
StoredBlocks blocks_of(const Mesh& mesh, const MapDescription& description);

/// `mesh`, which to_map() gave, as a block.
StoredBlock store_block(Mesh mesh);

}  // namespace deltamesh
