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
#include "split/layout.h"
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
MapPart neighbour(const LaidPart& part) {
  MapPart border{part.key, {}, {}};
  for (const BorderPosition& position : part.border)
    border.border.push_back({0, position.point, position.twin});
  return border;
}

}  // namespace

Result<std::vector<TilePart>> split_tile(const TilePlan& plan, const Tile& tile,
                                         std::span<const MeshView> meshes) noexcept {
  return guarded([&]() -> Result<std::vector<TilePart>> {
    std::vector<StoredBlocks> blocks;
    for (const MeshView& mesh : meshes) {
      DELTAMESH_TRY(const Mesh moved, to_map(mesh, plan.description));
      blocks.push_back(blocks_of(moved, plan.description));
    }
    std::map<std::pair<PartKey, Cell0>, std::vector<const StoredBlock*>> by_cell;
    for (const StoredBlocks& some : blocks) {
      for (const auto& [cell, block] : some) {
        const PartKey* key = find_part(plan, cell);
        if (key == nullptr) return invalid_argument("meshes are not those that tiles were planned with");
        by_cell[{*key, cell}].push_back(&block);
      }
    }
    BlockLists lists;
    for (const auto& [place, some] : by_cell) {
      auto& list = lists[place.first];
      list.insert(list.end(), some.begin(), some.end());
    }
    const Layout layout = lay_out(lists, plan.description);
    LinkTable table;
    std::vector<TilePart> parts;
    for (const LaidPart& part : layout.parts) {
      if (overlap(part.key, tile.cell)) {
        parts.push_back({assemble(part.key, part.blocks, part.border), {}});
        table.put(parts.back().part);
      } else {
        table.put(neighbour(part));
      }
    }
    for (TilePart& part : parts) part.links = table.links_of(part.part.key);
    return parts;
  });
}

Result<MapState> encode_tile(const MapCodec& codec, std::span<const TilePart> parts,
                             const PartQuality& quality) noexcept {
  return guarded([&]() -> Result<MapState> {
    std::vector<MapPart> all;
    for (const TilePart& part : parts) all.push_back(part.part);
    DELTAMESH_TRY(MapState state, code_parts(codec, all, all, quality));
    state.manifest.revision = 1;
    state.manifest.next_group = 1;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      state.manifest.entries[i].revision = 1;
      state.manifest.entries[i].links = parts[i].links;
    }
    return state;
  });
}

Result<MapManifest> merge_tiles(std::span<const MapManifest> tiles) noexcept {
  return guarded([&]() -> Result<MapManifest> {
    MapManifest whole{.revision = 1, .next_group = 1};
    for (const MapManifest& tile : tiles) {
      if (&tile == tiles.data()) whole.description = tile.description;
      if (tile.description != whole.description) return invalid_argument("tiles of different maps");
      whole.entries.insert(whole.entries.end(), tile.entries.begin(), tile.entries.end());
    }
    std::ranges::sort(whole.entries, {}, &PartEntry::key);
    if (std::ranges::adjacent_find(whole.entries, {}, &PartEntry::key) != whole.entries.end())
      return invalid_argument("a part is in two tiles");
    return whole;
  });
}

}  // namespace deltamesh
