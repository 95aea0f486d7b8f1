// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Maps of meshes from voxels: they say which grid, parts go by it, and no cube is cut.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <span>

#include "deltamesh/find_grid.h"
#include "deltamesh/map/encode_map.h"
#include "deltamesh/map/map_codec.h"
#include "deltamesh/map/split.h"
#include "field/marching_cubes.h"
#include "map/map_meshes.h"
#include "scenes.h"
#include "support/meshes.h"

namespace deltamesh {
namespace {

MapSettings settings_of(double part_edge) {
  MapSettings settings{.part_edge = part_edge};
  settings.quality.bounds.max_error = QualityBound{0.005};
  return settings;
}

/// How many cubes of `grid` have faces in more than one part.
std::size_t cubes_cut(const std::vector<MapPart>& parts, const VoxelGrid& grid) {
  std::map<std::array<int, 3>, PartKey> homes;
  std::size_t cut = 0;
  for (const MapPart& part : parts)
    for (std::size_t f = 0; f < part.mesh.triangle_count(); ++f) {
      std::array<int, 3> cube{};
      for (std::size_t k = 0; k < 3; ++k) {
        double sum = 0;
        for (std::size_t c = 0; c < 3; ++c)
          sum += double{part.mesh.positions[3 * std::size_t{part.mesh.triangles[3 * f + c]} + k]};
        cube[k] = static_cast<int>(std::floor((sum / 3 - grid.origin[k]) / grid.edge[k]));
      }
      cut += homes.emplace(cube, part.key).first->second == part.key ? 0 : 1;
    }
  return cut;
}

TEST(MapGrid, MAP4NoCubeIsInTwoParts) {
  const Mesh rooms = *generate_scene(Scene::kRooms, 4000, 1);
  MapDescription description{.cell_steps = 777, .attributes = test::attributes_of(rooms)};
  description.lattice.origin = rooms.origin;
  const auto grid = find_grid(rooms);
  ASSERT_TRUE(grid);
  const SplitOptions options{.most_triangles = 300};
  const auto without = split(rooms, description, options);
  ASSERT_TRUE(without);
  EXPECT_GT(cubes_cut(*without, *grid), 100U);
  description.grid = grid;
  const auto with = split(rooms, description, options);
  ASSERT_TRUE(with);
  EXPECT_GT(with->size(), 10U);
  EXPECT_EQ(cubes_cut(*with, *grid), 0U);
}

TEST(MapGrid, MAP4CubesBeyondTheLatticeDoNotCount) {
  Mesh mesh;
  mesh.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  mesh.triangles = {0, 1, 2};
  MapDescription description;
  description.grid = VoxelGrid{{-1e300, 0, 0}, {1e300, 1, 1e-300}};
  const auto parts = split(mesh, description, {.most_level = 0});
  ASSERT_TRUE(parts);
  EXPECT_EQ(parts->size(), 1U);
}

/// From voxels of 0.1 m: hills, and beside them a floor.
Mesh hills_and_floor() {
  constexpr std::uint32_t kNodes = 40;
  std::mt19937 random(1);
  std::vector<float> layer(std::size_t{kNodes} * kNodes);
  const scenes::Lattice lattice{.nodes = {3 * kNodes, kNodes, kNodes}, .voxel = 0.1, .base = {}};
  const auto surface = march_cubes(lattice, [&](std::uint32_t i) {
    for (std::uint32_t j = 0; j < kNodes; ++j) {
      const float hill =
          i < kNodes ? 6 * std::sin(static_cast<float>(i) / 4) * std::sin(static_cast<float>(j) / 5) : 0;
      const float height = 20 + hill + 0.4F * static_cast<float>(random() % 100000) / 100000;
      for (std::uint32_t k = 0; k < kNodes; ++k)
        layer[std::size_t{j} * kNodes + k] = static_cast<float>(k) - height;
    }
    return std::span<const float>(layer);
  });
  Mesh mesh;
  mesh.positions = surface.positions;
  mesh.triangles = surface.triangles;
  return mesh;
}

TEST(MapGrid, MAP7AFloorIsOnTheGridOfTheMap) {
  const auto state = encode_map(hills_and_floor(), settings_of(2));
  ASSERT_TRUE(state);
  EXPECT_GE(state->octets.size(), 6U);
  for (const auto& octets : state->octets)
    EXPECT_NE(std::to_integer<int>(octets[0]) & 3, 0);  // a primer, or in its voxels
}

TEST(MapGrid, AnUpdateStaysOnTheGridOfTheMap) {
  const Mesh rooms = *generate_scene(Scene::kRooms, 4000, 1);
  const auto first = encode_map(rooms, settings_of(2));
  ASSERT_TRUE(first);
  EXPECT_TRUE(first->manifest.description.grid);
  Mesh changed = rooms;
  changed.triangles.resize(changed.triangles.size() - changed.triangles.size() / 60 * 3);
  for (const bool is_changed : {true, false}) {
    const auto next = encode_map(is_changed ? changed : rooms, settings_of(2), &*first);
    ASSERT_TRUE(next);
    EXPECT_EQ(next->manifest.description, first->manifest.description);
    std::size_t kept = 0;
    for (const PartEntry& entry : next->manifest.entries)
      kept += std::ranges::count(first->manifest.entries, entry.hash, &PartEntry::hash) != 0 ? 1 : 0;
    EXPECT_GT(2 * kept, first->manifest.entries.size());
  }
  Mesh empty = rooms;
  empty.triangles.clear();
  const auto none = encode_map(empty, settings_of(2), &*first);
  ASSERT_TRUE(none) << describe(none.error());
  EXPECT_EQ(none->manifest.description, first->manifest.description);
}

/// Voxels beside three times as many triangles that are not.
Mesh rooms_beside_others() {
  Mesh mesh = hills_and_floor();
  const Mesh others = test::random_mesh(2, 6000, 3 * static_cast<std::uint32_t>(mesh.triangle_count()));
  const auto first = static_cast<std::uint32_t>(mesh.vertex_count());
  for (std::size_t i = 0; i < others.positions.size(); ++i)
    mesh.positions.push_back(4 * others.positions[i] + (i % 3 == 0 ? 15 : 0));
  for (const std::uint32_t v : others.triangles) mesh.triangles.push_back(first + v);
  return mesh;
}

TEST(MapGrid, TheSameMeshAgainIsNoUpdate) {
  for (const Mesh& mesh : {hills_and_floor(), rooms_beside_others()}) {
    const auto first = encode_map(mesh, settings_of(2));
    ASSERT_TRUE(first);
    const auto again = encode_map(mesh, settings_of(2), &*first);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->manifest.revision, 1U);
    EXPECT_EQ(again->octets, first->octets);
  }
}

TEST(MapGrid, PrimersLeaveTheGridAsItIs) {
  MapDescription description;
  const auto parts = split(hills_and_floor(), description, {.most_triangles = 3000});
  ASSERT_TRUE(parts);
  const auto primed = with_primers(description, *parts, {.bounds = {.max_error = QualityBound{0.005}}});
  ASSERT_TRUE(primed);
  EXPECT_FALSE(primed->primers.empty());
  EXPECT_FALSE(primed->grid);
}

TEST(MapGrid, AnotherGridIsAnotherEpoch) {
  Mesh mesh = hills_and_floor();
  const auto first = encode_map(mesh, settings_of(2));
  ASSERT_TRUE(first);
  for (float& x : mesh.positions) x *= 1.125F;
  const auto second = encode_map(mesh, settings_of(2), &*first);
  ASSERT_TRUE(second);
  const MapDescription& description = second->manifest.description;
  EXPECT_EQ(description.epoch, first->manifest.description.epoch + 1);
  ASSERT_TRUE(description.grid);
  EXPECT_NEAR(description.grid->edge[0], 0.1125, 1e-6);
}

TEST(MapGrid, AMapOfOtherMeshesHasNone) {
  const auto state = encode_map(test::wavy_sheet(40, 30, 1, 0), settings_of(1));
  ASSERT_TRUE(state);
  EXPECT_FALSE(state->manifest.description.grid);
}

}  // namespace
}  // namespace deltamesh
