// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "send/seen_cells.h"

#include <algorithm>

#include "part/view_cells.h"

namespace deltamesh {

SeenCells::SeenCells(const Viewer& viewer, const SourceMap& map, const MapDescription& description) {
  const View& view = viewer.view;
  for (const auto& [key, part] : map.parts()) {
    if (map.is_copy(key)) continue;
    const std::uint8_t seen = std::max(key.level, view.level);
    if (!is_in_view(ancestor(key, seen), view, description)) continue;
    for (int level = seen; level <= kMostPartLevel; ++level)
      if (!seen_.insert(ancestor(key, static_cast<std::uint8_t>(level))).second) break;
  }
  for (const auto& [key, believed] : viewer.has) {
    if (believed.is_gone || key.level < view.level) continue;
    has_.insert(key);
    for (int level = key.level; level <= kMostPartLevel; ++level)
      if (!above_.insert(ancestor(key, static_cast<std::uint8_t>(level))).second) break;
  }
}

bool SeenCells::is_begun(const PartKey& cell) const {
  if (above_.contains(cell)) return true;
  for (int level = cell.level + 1; level <= kMostPartLevel; ++level)
    if (has(ancestor(cell, static_cast<std::uint8_t>(level)))) return true;
  return false;
}

}  // namespace deltamesh
