// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "octree.h"

#include <cstdint>

namespace deltamesh {

std::map<Cell0, PartKey> parts_of_cells(const StoredBlocks& blocks, const SplitOptions& options) {
  std::map<Cell0, PartKey> parts;
  std::map<Cell0, std::uint64_t> counts;  // triangles of the cells of a level that may still be parts
  for (const auto& [cell, block] : blocks) parts[cell] = {0, cell[0], cell[1], cell[2]};
  for (std::uint8_t level = 1; level <= options.most_level; ++level) {
    counts.clear();
    for (const auto& [cell, block] : blocks)
      counts[{cell[0] >> level, cell[1] >> level, cell[2] >> level}] += block.mesh.triangle_count();
    bool any = false;
    for (auto& [cell, key] : parts) {
      const Cell0 above{cell[0] >> level, cell[1] >> level, cell[2] >> level};
      if (counts[above] > options.most_triangles) continue;
      key = {level, above[0], above[1], above[2]};
      any = true;
    }
    if (!any) break;  // what holds too much holds it on all levels above
  }
  return parts;
}

}  // namespace deltamesh
