// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Tiles make the parts, borders and links that the whole map has, whatever the files that it comes in.
#include <gtest/gtest.h>

#include "deltamesh/map/split.h"
#include "deltamesh/map/tiles.h"
#include "map/map_meshes.h"
#include "part/link_table.h"
#include "scenes.h"
#include "support/row_gather.h"

namespace deltamesh {
namespace {

/// `count` meshes of runs of faces.
std::vector<Mesh> pieces_of(const Mesh& mesh, std::size_t count) {
  std::vector<Mesh> pieces;
  RowGather gather{MeshView(mesh)};
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t f = i * mesh.triangle_count() / count; f < (i + 1) * mesh.triangle_count() / count; ++f)
      gather.add_face(f);
    pieces.push_back(gather.take());
  }
  return pieces;
}

TilePlan plan_of(const std::vector<Mesh>& pieces, const MapSettings& settings, std::uint64_t tile_triangles) {
  auto planner = TilePlanner::make(settings, tile_triangles);
  EXPECT_TRUE(planner);
  for (const Mesh& piece : pieces) EXPECT_TRUE(planner->add(piece));
  auto plan = planner->plan();
  EXPECT_TRUE(plan);
  return *std::move(plan);
}

std::vector<MeshView> meshes_of(const Tile& tile, const std::vector<Mesh>& pieces) {
  std::vector<MeshView> meshes;
  for (const std::uint32_t i : tile.meshes) meshes.push_back(pieces[i]);
  return meshes;
}

void expect_the_same_parts(const Mesh& mesh, double part_edge) {
  MapSettings settings{.part_edge = part_edge, .most_triangles = 300};
  settings.quality.bounds.max_error = QualityBound{0.002};
  for (const std::size_t count : {1U, 7U, 40U}) {
    const auto pieces = pieces_of(mesh, count);
    const TilePlan plan = plan_of(pieces, settings, 1500);
    EXPECT_GT(plan.tiles.size(), 2U);
    const auto whole = split(mesh, plan.description, {.most_triangles = 300, .most_level = 3});
    ASSERT_TRUE(whole) << describe(whole.error());
    LinkTable links;
    std::map<PartKey, const MapPart*> parts;
    for (const MapPart& part : *whole) {
      links.put(part);
      parts[part.key] = &part;
    }
    for (const Tile& tile : plan.tiles) {
      const auto tile_parts = split_tile(plan, tile, meshes_of(tile, pieces));
      ASSERT_TRUE(tile_parts) << describe(tile_parts.error());
      for (const TilePart& part : *tile_parts) {
        const auto found = parts.extract(part.part.key);
        ASSERT_FALSE(found.empty());
        const MapPart& expected = *found.mapped();
        EXPECT_EQ(part.part.mesh.positions, expected.mesh.positions);
        EXPECT_EQ(part.part.mesh.triangles, expected.mesh.triangles);
        EXPECT_EQ(part.part.border, expected.border);
        EXPECT_EQ(part.links, links.links_of(expected.key));
      }
    }
    EXPECT_TRUE(parts.empty());
  }
}

TEST(MapTiles, TilesMakeThePartsOfTheWholeMap) {
  expect_the_same_parts(*generate_scene(Scene::kRooms, 4000, 1), 2);
  expect_the_same_parts(test::wavy_sheet(50, 50, 1, 0.002), 0.3);
  expect_the_same_parts(test::random_mesh(3, 900, 3000), 0.4);
}

TEST(MapTiles, MergedTilesAreAMap) {
  const Mesh mesh = test::wavy_sheet(50, 50, 1, 0.002);
  MapSettings settings{.part_edge = 0.3, .most_triangles = 300};
  settings.quality.bounds.max_error = QualityBound{0.002};
  const auto pieces = pieces_of(mesh, 5);
  TilePlan plan = plan_of(pieces, settings, 1500);
  plan.revision = 7;
  plan.group = 3;
  const auto codec = MapCodec::open(plan.description);
  MapState whole;
  std::vector<MapManifest> tiles;
  std::map<PartKey, std::vector<std::byte>> octets;
  for (const Tile& tile : plan.tiles) {
    const auto state = encode_tile(*codec, *split_tile(plan, tile, meshes_of(tile, pieces)), plan);
    ASSERT_TRUE(state);
    for (std::size_t i = 0; i < state->octets.size(); ++i)
      octets[state->manifest.entries[i].key] = state->octets[i];
    tiles.push_back(state->manifest);
  }
  std::ranges::reverse(tiles);
  auto merged = merge_tiles(tiles);
  ASSERT_TRUE(merged);
  EXPECT_TRUE(write_manifest(*merged));
  EXPECT_EQ(merged->revision, 7U);
  EXPECT_EQ(merged->next_group, 4U);
  for (const PartEntry& entry : merged->entries) EXPECT_EQ(entry.revision, 7U);
  whole.manifest = *merged;
  for (const auto& [key, bytes] : octets) whole.octets.push_back(bytes);
  EXPECT_EQ(test::topology_counts(*decode_map(whole)), test::topology_counts(mesh));
  tiles.push_back(tiles.front());
  EXPECT_EQ(merge_tiles(tiles).error().code, ErrorCode::kInvalidArgument);
}

TEST(MapTiles, RefusesWhatNoTileCanKeep) {
  MapSettings settings{.part_edge = 1};
  EXPECT_EQ(TilePlanner::make(settings, 100000).error().code, ErrorCode::kInvalidArgument);
  settings.quality.bounds.max_error = QualityBound{0.1, QualityUnit::kDiagonal};
  EXPECT_EQ(TilePlanner::make(settings, 100000).error().code, ErrorCode::kInvalidArgument);
  settings.quality.bounds.max_error = QualityBound{0.1};
  EXPECT_EQ(TilePlanner::make(settings, 1000).error().code, ErrorCode::kInvalidArgument);
  auto planner = TilePlanner::make(settings, 100000);
  ASSERT_TRUE(planner);
  EXPECT_EQ(planner->plan().error().code, ErrorCode::kInvalidArgument);
  // Another mesh than planned with.
  ASSERT_TRUE(planner->add(test::wavy_sheet(5, 5, 1, 0)));
  const auto plan = planner->plan();
  ASSERT_TRUE(plan);
  Mesh moved = test::wavy_sheet(5, 5, 1, 0);
  moved.positions[0] += 0.001F;
  const std::vector<MeshView> meshes{moved};
  const auto other = split_tile(*plan, plan->tiles[0], meshes);
  EXPECT_EQ(other.error().code, ErrorCode::kInvalidMesh);
  EXPECT_EQ(other.error().where_kind, WhereKind::kElement);
  // The first mesh says which attributes all have.
  Mesh bare = test::wavy_sheet(5, 5, 1, 0);
  bare.attributes.clear();
  EXPECT_EQ(describe(planner->add(bare).error()), "the mesh lacks an attribute of the map: 'colours'");
  Mesh more = test::wavy_sheet(5, 5, 1, 0);
  more.attributes.push_back(more.attributes.front());
  EXPECT_EQ(describe(planner->add(more).error()), "the map lacks an attribute of the mesh: 'colours'");
}

}  // namespace
}  // namespace deltamesh
