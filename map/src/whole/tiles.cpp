// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/map/tiles.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/guard.h"
#include "base/try.h"
#include "part/link_table.h"
#include "split/assemble.h"
#include "split/borders.h"
#include "split/stored_block.h"
#include "support/errors.h"
#include "whole/coded_parts.h"

namespace deltamesh {
namespace {

/// Null: the plan has no part there.
const PartKey* find_part(const TilePlan& plan, const Cell0& cell) noexcept {
  const PartKey smallest{0, cell[0], cell[1], cell[2]};
  if (plan.parts.empty()) return nullptr;
  for (int level = 0; level <= plan.parts.back().level; ++level) {
    const PartKey key = ancestor(smallest, static_cast<std::uint8_t>(level));
    const auto found = std::ranges::lower_bound(plan.parts, key);
    if (found != plan.parts.end() && *found == key) return &*found;
  }
  return nullptr;
}

/// A part that is not of the tile: its border alone.
MapPart neighbour(const PartKey& key, const std::vector<BorderPosition>& positions) {
  MapPart border{key, {}, {}};
  for (const BorderPosition& position : positions)
    border.border.push_back({0, position.point, position.twin});
  return border;
}

/// The borders of parts of these blocks.
Borders borders_between(const std::vector<PlacedBlock>& blocks, const MapLattice& lattice) {
  Borders borders(lattice);
  std::vector<const Mesh*> meshes;
  for (const PlacedBlock& block : blocks) {
    borders.add(block);
    meshes.push_back(&block.block.mesh);
  }
  borders.change({}, borders.at(points_of(meshes, lattice)));
  return borders;
}

}  // namespace

Result<std::vector<TilePart>> split_tile(const TilePlan& plan, const Tile& tile,
                                         std::span<const MeshView> meshes) noexcept {
  return guarded([&]() -> Result<std::vector<TilePart>> {
    std::vector<PlacedBlock> blocks;
    std::map<PartKey, std::map<Cell0, std::vector<std::size_t>>> places;
    if (meshes.size() != tile.meshes.size()) return invalid_argument("not as many meshes as the tile has");
    for (std::size_t number = 0; number < meshes.size(); ++number) {
      const Error other =
          invalid_mesh("the mesh is not the one that tiles were planned with", WhereKind::kElement, number);
      Result<Mesh> moved = to_map(meshes[number], plan.description);
      if (!moved) return moved.error().code == ErrorCode::kOutOfMemory ? moved.error() : other;
      const StoredBlock whole = store_block(*std::move(moved));
      if (whole.hash != plan.mesh_hashes.at(tile.meshes[number])) return other;
      for (auto& [cell, block] : blocks_of(whole.mesh, plan.description)) {
        const PartKey* key = find_part(plan, cell);
        if (key == nullptr) return other;
        places[*key][cell].push_back(blocks.size());
        blocks.push_back({std::move(block), *key});
      }
    }
    const Borders borders = borders_between(blocks, plan.description.lattice);
    LinkTable table;
    std::vector<TilePart> parts;
    for (const auto& [key, cells] : places) {
      if (!overlap(key, tile.cell)) {
        table.put(neighbour(key, borders.of(key)));
        continue;
      }
      std::vector<const StoredBlock*> list;
      for (const auto& [cell, some] : cells)
        for (const std::size_t i : some) list.push_back(&blocks[i].block);
      parts.push_back({assemble(key, list, borders.of(key)), {}});
      table.put(parts.back().part);
    }
    for (TilePart& part : parts) part.links = table.links_of(part.part.key);
    return parts;
  });
}

Result<MapState> encode_tile(const MapCodec& codec, std::span<const TilePart> parts,
                             const TilePlan& plan) noexcept {
  return guarded([&]() -> Result<MapState> {
    std::vector<MapPart> all;
    for (const TilePart& part : parts) all.push_back(part.part);
    DELTAMESH_TRY(MapState state, code_parts(codec, all, all, plan.quality));
    state.manifest.revision = plan.revision;
    state.manifest.next_group = plan.group + 1;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      state.manifest.entries[i].revision = plan.revision;
      state.manifest.entries[i].group = plan.group;
      state.manifest.entries[i].links = parts[i].links;
    }
    return state;
  });
}

Result<MapManifest> merge_tiles(std::span<const MapManifest> tiles) noexcept {
  return guarded([&]() -> Result<MapManifest> {
    MapManifest whole;
    if (!tiles.empty()) {
      whole.description = tiles.front().description;
      whole.revision = tiles.front().revision;
      whole.next_group = tiles.front().next_group;
    }
    for (const MapManifest& tile : tiles) {
      if (tile.description != whole.description || tile.revision != whole.revision ||
          tile.next_group != whole.next_group)
        return invalid_argument("tiles of different maps");
      whole.entries.insert(whole.entries.end(), tile.entries.begin(), tile.entries.end());
    }
    std::ranges::sort(whole.entries, {}, &PartEntry::key);
    if (std::ranges::adjacent_find(whole.entries, {}, &PartEntry::key) != whole.entries.end())
      return invalid_argument("a part is in two tiles");
    return whole;
  });
}

}  // namespace deltamesh
