// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "split/layout.h"

#include <algorithm>
#include <utility>

#include "split/assemble.h"

namespace deltamesh {

void Layout::leave_out_known(StoredBlocks& blocks) const {
  std::erase_if(blocks, [&](const auto& entry) {
    const auto known = blocks_.find(entry.first);
    if (known == blocks_.end()) return entry.second.mesh.triangles.empty();
    return known->second.block.hash == entry.second.hash;
  });
}

/// Parts that the blocks replace, split or join, once the octree has counted them.
std::set<PartKey> Layout::parts_before(const StoredBlocks& blocks) const {
  std::set<PartKey> parts;
  std::set<PartKey> places;
  for (const auto& [cell, block] : blocks) {
    for (std::uint8_t level = 0; level <= size_.most_level; ++level)
      if (const PartKey above = ancestor(key_of(cell), level); parts_.contains(above)) parts.insert(above);
    places.insert(octree_.part_of(cell, size_));
  }
  std::vector<Cell0> cells;
  for (const PartKey& place : places) octree_.add_cells_in(place, cells);
  for (const Cell0& cell : cells)
    if (const auto known = blocks_.find(cell); known != blocks_.end()) parts.insert(known->second.part);
  return parts;
}

/// The cells that have blocks after an update and are in these parts, or new.
std::set<Cell0> Layout::cells_of(const std::set<PartKey>& parts, const StoredBlocks& blocks) const {
  std::vector<Cell0> cells;
  for (const PartKey& part : parts) octree_.add_cells_in(part, cells);
  for (const auto& [cell, block] : blocks)
    if (!block.mesh.triangles.empty()) cells.push_back(cell);
  return {cells.begin(), cells.end()};
}

void Layout::replace(StoredBlocks&& blocks) {
  std::size_t vertices = 0;
  for (const auto& [cell, block] : blocks)
    if (!blocks_.contains(cell)) vertices += block.mesh.vertex_count();
  borders_.reserve(vertices);
  for (auto& [cell, block] : blocks) {
    const auto known = blocks_.find(cell);
    if (known != blocks_.end()) borders_.remove(known->second);
    if (block.mesh.triangles.empty()) {
      blocks_.erase(known);
      continue;
    }
    PlacedBlock& placed = known != blocks_.end() ? known->second : blocks_[cell];
    placed.block = std::move(block);
    borders_.add(placed);
  }
}

LayoutChange Layout::update(StoredBlocks blocks) {
  LayoutChange change;
  leave_out_known(blocks);
  std::vector<const Mesh*> meshes;  // whose positions may be on other borders than before
  for (const auto& [cell, block] : blocks) {
    if (const auto known = blocks_.find(cell); known != blocks_.end()) {
      octree_.remove(cell, known->second.block.mesh.triangle_count());
      meshes.push_back(&known->second.block.mesh);
    }
    octree_.add(cell, block.mesh.triangle_count());
    meshes.push_back(&block.mesh);
  }
  const std::set<PartKey> before = parts_before(blocks);
  std::map<Cell0, PartKey> places;
  for (const Cell0& cell : cells_of(before, blocks)) {
    places[cell] = octree_.part_of(cell, size_);
    change.changed.insert(places[cell]);
    const auto known = blocks_.find(cell);
    if (known != blocks_.end() && known->second.part != places[cell] && !blocks.contains(cell))
      meshes.push_back(&known->second.block.mesh);
  }
  std::ranges::set_difference(before, change.changed, std::inserter(change.removed, change.removed.end()));

  const std::vector<LatticePoint> points = points_of(meshes, lattice_);
  const std::vector<BorderUse> uses = borders_.at(points);
  replace(std::move(blocks));
  for (const auto& [cell, part] : places) blocks_.at(cell).part = part;
  BorderChange borders = borders_.change(uses, borders_.at(points));

  for (const PartKey& key : change.removed) parts_.erase(key);
  parts_.insert(change.changed.begin(), change.changed.end());
  for (const PartKey& key : borders.changed)
    if (parts_.contains(key)) change.changed.insert(key);
  change.touched = std::move(borders.touched);
  change.touched.insert(change.changed.begin(), change.changed.end());
  change.touched.insert(change.removed.begin(), change.removed.end());
  change.pairs = std::move(borders.pairs);
  return change;
}

bool Layout::is_above_parts(const PartKey& cell) const {
  if (cell.level == 0 || !octree_.contains(cell)) return false;
  for (std::uint8_t level = cell.level; level <= kMostPartLevel; ++level)
    if (parts_.contains(ancestor(cell, level))) return false;
  return true;
}

std::vector<const StoredBlock*> Layout::blocks_in(const PartKey& key) const {
  std::vector<Cell0> cells;
  octree_.add_cells_in(key, cells);
  std::ranges::sort(cells);
  std::vector<const StoredBlock*> blocks;
  blocks.reserve(cells.size());
  for (const Cell0& cell : cells) blocks.push_back(&blocks_.at(cell).block);
  return blocks;
}

MapPart Layout::part(const PartKey& key) const { return assemble(key, blocks_in(key), borders_.of(key)); }

std::vector<BorderPosition> Layout::border_of(const PartKey& cell) const {
  std::vector<Cell0> cells;
  octree_.add_cells_in(cell, cells);
  std::set<PartKey> parts;
  for (const Cell0& c : cells) parts.insert(blocks_.at(c).part);
  std::vector<BorderPosition> border;
  for (const PartKey& part : parts) {
    const std::vector<BorderPosition> own = borders_.outside(part, cell);
    border.insert(border.end(), own.begin(), own.end());
  }
  std::ranges::sort(border);
  border.erase(std::unique(border.begin(), border.end()), border.end());
  return border;
}

}  // namespace deltamesh
