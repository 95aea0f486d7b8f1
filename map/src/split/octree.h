// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Finds the part of every cell of level 0: a cell of the octree.
#pragma once

#include <cstdint>
#include <map>

#include "deltamesh/map/part_key.h"
#include "split/stored_block.h"

namespace deltamesh {

/// Number of triangles of every cell of level 0 that has any.
using TriangleCounts = std::map<Cell0, std::uint64_t>;
TriangleCounts triangle_counts(const StoredBlocks& blocks);

/// For every cell the largest cell of up to `most_level` that holds it and has at most `most_triangles`, or
/// itself. O(cells * levels * log).
std::map<Cell0, PartKey> parts_of_cells(const TriangleCounts& cells, std::uint64_t most_triangles,
                                        std::uint8_t most_level);

}  // namespace deltamesh
