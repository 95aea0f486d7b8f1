// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "split/octree.h"

namespace deltamesh {

TriangleCounts triangle_counts(const StoredBlocks& blocks) {
  TriangleCounts counts;
  for (const auto& [cell, block] : blocks) counts[cell] = block.mesh.triangle_count();
  return counts;
}

std::map<Cell0, PartKey> parts_of_cells(const TriangleCounts& cells, std::uint64_t most_triangles,
                                        std::uint8_t most_level) {
  std::map<Cell0, PartKey> parts;
  TriangleCounts counts;  // of the cells of a level that may still be parts
  for (const auto& [cell, count] : cells) parts[cell] = {0, cell[0], cell[1], cell[2]};
  for (std::uint8_t level = 1; level <= most_level; ++level) {
    counts.clear();
    for (const auto& [cell, count] : cells)
      counts[{cell[0] >> level, cell[1] >> level, cell[2] >> level}] += count;
    bool any = false;
    for (auto& [cell, key] : parts) {
      const Cell0 above{cell[0] >> level, cell[1] >> level, cell[2] >> level};
      if (counts[above] > most_triangles) continue;
      key = {level, above[0], above[1], above[2]};
      any = true;
    }
    if (!any) break;  // what holds too much holds it on all levels above
  }
  return parts;
}

}  // namespace deltamesh
