// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "split/octree.h"

namespace deltamesh {

void Octree::add(const Cell0& cell, std::uint64_t triangles) {
  if (triangles == 0) return;
  for (std::uint8_t level = 0; level <= kMostPartLevel; ++level)
    triangles_[ancestor(key_of(cell), level)] += triangles;
}

void Octree::remove(const Cell0& cell, std::uint64_t triangles) {
  if (triangles == 0) return;
  for (std::uint8_t level = 0; level <= kMostPartLevel; ++level) {
    const auto found = triangles_.find(ancestor(key_of(cell), level));
    found->second -= triangles;
    if (found->second == 0) triangles_.erase(found);
  }
}

std::uint64_t Octree::triangles_in(const PartKey& key) const {
  const auto found = triangles_.find(key);
  return found == triangles_.end() ? 0 : found->second;
}

PartKey Octree::part_of(const Cell0& cell, const PartSize& size) const {
  PartKey key = key_of(cell);
  while (key.level < size.most_level) {  // what holds too much holds it on all levels above
    const PartKey above = ancestor(key, static_cast<std::uint8_t>(key.level + 1));
    if (triangles_in(above) > size.most_triangles) break;
    key = above;
  }
  return key;
}

void Octree::add_cells_in(const PartKey& key, std::vector<Cell0>& cells) const {
  if (!triangles_.contains(key)) return;
  if (key.level == 0) {
    cells.push_back({key.x, key.y, key.z});
    return;
  }
  for (const PartKey& child : children_of(key)) add_cells_in(child, cells);
}

std::map<Cell0, std::uint64_t> Octree::cells() const {
  std::map<Cell0, std::uint64_t> cells;
  for (const auto& [key, count] : triangles_) {
    if (key.level > 0) break;
    cells[{key.x, key.y, key.z}] = count;
  }
  return cells;
}

}  // namespace deltamesh
