// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Maps larger than a machine's memory: tiles that are encoded one by one, in any order, by processes that
// know nothing of each other but the plan.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "deltamesh/map/encode_map.h"
#include "deltamesh/map/folder.h"
#include "deltamesh/map/map_codec.h"
#include "deltamesh/map/part.h"
#include "deltamesh/map/part_quality.h"
#include "deltamesh/result.h"

namespace deltamesh {

struct Tile {
  PartKey cell{};
  std::uint64_t triangles = 0;
  std::vector<std::uint32_t> meshes{};  ///< all that have faces in the cell, or next to them; ascending
};

struct TilePlan {
  MapDescription description{};
  PartQuality quality{};                     ///< with what the settings do not say of colours
  std::uint64_t revision = 1;                ///< the number of the update that the tiles make together
  std::uint64_t group = 0;                   ///< and of its group
  std::vector<std::uint64_t> mesh_hashes{};  ///< of the content of every mesh, by number
  std::vector<PartKey> parts{};              ///< ascending; every face is in one
  std::vector<Tile> tiles{};                 ///< ascending by cell; every part is in one
};

/// Looks at all meshes of a map, one after another. Memory: in proportion to the cells of level 0.
class TilePlanner {
 public:
  /// `tile_triangles`: a tile is the largest cell with no more, or a part; at least settings.most_triangles.
  /// Errors: kInvalidArgument (also bounds that are not in model units, or none, and coarser levels).
  static Result<TilePlanner> make(const MapSettings& settings, std::uint64_t tile_triangles) noexcept;

  /// The first mesh gives the map's origin, attributes and grid, if it has one. Meshes fit together where
  /// positions relative to that origin are the same to the bit. Errors: as split().
  Result<void> add(const MeshView& mesh) noexcept;

  /// Without primers. Errors: kInvalidArgument (no mesh), kOutOfMemory.
  Result<TilePlan> plan() const noexcept;

  TilePlanner(TilePlanner&&) noexcept;
  TilePlanner& operator=(TilePlanner&&) noexcept;
  ~TilePlanner();

 private:
  struct State;
  explicit TilePlanner(std::unique_ptr<State> state) noexcept;
  std::unique_ptr<State> state_;
};

struct TilePart {
  MapPart part;
  std::vector<PartLink> links;  ///< also to parts of other tiles
};

/// The parts of a tile, ascending by key: those that split() makes of all meshes after each other, in cells
/// as the plan has them. `meshes`: those of the tile, in its order. Errors: kInvalidArgument (more or fewer
/// meshes), kInvalidMesh (another mesh than planned with; WhereKind::kElement counts in `meshes`),
/// kOutOfMemory.
Result<std::vector<TilePart>> split_tile(const TilePlan& plan, const Tile& tile,
                                         std::span<const MeshView> meshes) noexcept;

/// A map of these parts alone, in the plan's revision. `codec`: of the plan's description. Errors: as
/// MapCodec::encode().
Result<MapState> encode_tile(const MapCodec& codec, std::span<const TilePart> parts,
                             const TilePlan& plan) noexcept;

/// The whole map, from the manifests of all its tiles in any order. Errors: kInvalidArgument (a part twice,
/// or other descriptions or revisions).
Result<MapManifest> merge_tiles(std::span<const MapManifest> tiles) noexcept;

}  // namespace deltamesh
