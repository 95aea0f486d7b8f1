// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// All parts of a map, as its blocks make them.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "deltamesh/map/description.h"
#include "deltamesh/map/split.h"
#include "lattice/border_table.h"
#include "split/stored_block.h"

namespace deltamesh {

struct LaidPart {
  PartKey key{};
  std::vector<const StoredBlock*> blocks;  ///< by cell
  std::vector<BorderPosition> border;
  std::uint64_t hash = 0;  ///< of the blocks and the border
};

struct Layout {
  std::vector<LaidPart> parts;  ///< ascending by key
  std::vector<BorderUse> uses;  ///< parts by their place
};

/// The blocks of every part, in ascending order of their cells.
using BlockLists = std::map<PartKey, std::vector<const StoredBlock*>>;
/// Blocks must outlive the layout. O(n log n).
Layout lay_out(const BlockLists& lists, const MapDescription& description);
/// The same, each block in the part that the options make of its cell.
Layout lay_out(const StoredBlocks& blocks, const MapDescription& description, const SplitOptions& options);

}  // namespace deltamesh
