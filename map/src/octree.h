// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which cell of the octree is the part of a cell of level 0.
#pragma once

#include <map>

#include "deltamesh/map/part_key.h"
#include "deltamesh/map/split.h"
#include "stored_block.h"

namespace deltamesh {

/// The part of every block, as SplitOptions has it. O(blocks * levels * log).
std::map<Cell0, PartKey> parts_of_cells(const StoredBlocks& blocks, const SplitOptions& options);

}  // namespace deltamesh
