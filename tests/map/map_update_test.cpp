// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Updates of a map: only what changed is told, and what goes together has one group number.
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>
#include <tuple>

#include "deltamesh/map/join.h"
#include "deltamesh/map/split.h"
#include "map/map_meshes.h"

namespace deltamesh {
namespace {

using test::face_bits;
using Cell = std::array<std::int32_t, 3>;

/// Two triangles on the square [x, x + 1) x [y, y + 1); `height` of its four corners.
Mesh square(int x, int y, const std::map<std::pair<int, int>, float>& heights) {
  Mesh mesh;
  for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
    const auto height = heights.find({x + dx, y + dy});
    for (const float coordinate : {static_cast<float>(x + dx), static_cast<float>(y + dy),
                                   height == heights.end() ? 0.0F : height->second})
      mesh.positions.push_back(coordinate);
  }
  mesh.triangles = {0, 1, 2, 1, 3, 2};
  return mesh;
}

MapDescription unit_cells() {
  MapDescription description{.cell_steps = 64};
  description.lattice.step_exponent = -6;
  return description;
}

/// The receiver's map: parts by key.
using Parts = std::map<PartKey, MapPart>;

void apply(const MapChange& change, Parts& parts) {
  for (const RemovedPart& removed : change.removed) EXPECT_EQ(parts.erase(removed.key), 1U);
  for (const ChangedPart& changed : change.changed) parts[changed.part.key] = changed.part;
}

std::vector<test::FaceBits> faces_of(const Parts& parts) {
  std::vector<MapPart> list;
  for (const auto& [key, part] : parts) list.push_back(part);
  return face_bits(*join(list));
}

TEST(MapUpdate, OnlyTouchedPartsChange) {
  auto splitter = Splitter::make(unit_cells(), {.most_triangles = 1, .most_level = 0});
  ASSERT_TRUE(splitter);
  std::vector<Mesh> meshes;
  std::vector<MapBlock> blocks;
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 4; ++y) meshes.push_back(square(x, y, {}));
  for (int i = 0; i < 16; ++i) blocks.push_back({{i / 4, i % 4, 0}, meshes[static_cast<std::size_t>(i)]});
  const auto first = splitter->update(blocks);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->changed.size(), 16U);
  EXPECT_TRUE(splitter->update(blocks)->changed.empty());

  // The corner (2, 2) belongs to four blocks: all of them change, in one group.
  const std::map<std::pair<int, int>, float> heights = {{{2, 2}, 0.5F}};
  meshes.clear();
  blocks.clear();
  for (const auto& [x, y] : {std::pair{1, 1}, {1, 2}, {2, 1}, {2, 2}})
    meshes.push_back(square(x, y, heights));
  for (int i = 0; i < 4; ++i)
    blocks.push_back({{1 + i / 2, 1 + i % 2, 0}, meshes[static_cast<std::size_t>(i)]});
  const auto second = splitter->update(blocks);
  ASSERT_TRUE(second);
  ASSERT_EQ(second->changed.size(), 4U);
  for (const ChangedPart& changed : second->changed) {
    EXPECT_EQ(changed.group, second->changed.front().group);
    EXPECT_EQ(changed.revision, 3U);
  }
}

TEST(MapUpdate, MAP9PartsWithoutACommonChangeAreInGroupsOfTheirOwn) {
  auto splitter = Splitter::make(unit_cells(), {.most_triangles = 1, .most_level = 0});
  ASSERT_TRUE(splitter);
  const std::vector<Mesh> meshes = {square(0, 0, {}), square(1, 0, {}), square(5, 0, {})};
  ASSERT_TRUE(splitter->update(
      std::vector<MapBlock>{{{0, 0, 0}, meshes[0]}, {{1, 0, 0}, meshes[1]}, {{5, 0, 0}, meshes[2]}}));
  // Corners that no other block has.
  const Mesh a = square(0, 0, {{{0, 0}, 0.25F}});
  const Mesh b = square(1, 0, {{{2, 0}, 0.25F}});
  const auto change = splitter->update(std::vector<MapBlock>{{{0, 0, 0}, a}, {{1, 0, 0}, b}});
  ASSERT_TRUE(change);
  ASSERT_EQ(change->changed.size(), 2U);
  EXPECT_NE(change->changed[0].group, change->changed[1].group);
  // A block goes: its neighbour has no border there any more, and goes with it.
  const auto gone = splitter->update(std::vector<MapBlock>{{{0, 0, 0}, MeshView()}});
  ASSERT_TRUE(gone);
  ASSERT_EQ(gone->removed.size(), 1U);
  ASSERT_EQ(gone->changed.size(), 1U);
  EXPECT_EQ(gone->removed[0].group, gone->changed[0].group);
  EXPECT_TRUE(gone->changed[0].part.border.empty());
}

TEST(MapUpdate, MergedAndSplitCellsAreInOneGroup) {
  auto splitter = Splitter::make(unit_cells(), {.most_triangles = 4, .most_level = 2});
  ASSERT_TRUE(splitter);
  const std::vector<Mesh> meshes = {square(0, 0, {}), square(1, 0, {}), square(1, 1, {})};
  Parts parts;
  const auto first = splitter->update(std::vector<MapBlock>{{{0, 0, 0}, meshes[0]}, {{1, 0, 0}, meshes[1]}});
  ASSERT_TRUE(first);
  ASSERT_EQ(first->changed.size(), 1U);  // both in one cell of level 2
  apply(*first, parts);
  const auto second = splitter->update(std::vector<MapBlock>{{{1, 1, 0}, meshes[2]}});
  ASSERT_TRUE(second);
  EXPECT_EQ(second->removed.size(), 1U);
  EXPECT_EQ(second->changed.size(), 3U);
  for (const ChangedPart& changed : second->changed) EXPECT_EQ(changed.group, second->removed[0].group);
  apply(*second, parts);
  EXPECT_EQ(faces_of(parts).size(), 6U);
}

TEST(MapUpdate, AnySequenceEndsWithWhatAFreshSplitterGives) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    const SplitOptions options{1 + seed * 3, static_cast<std::uint8_t>(seed % 4),
                               static_cast<std::uint8_t>(seed % 3 * 2)};
    auto splitter = Splitter::make(unit_cells(), options);
    ASSERT_TRUE(splitter);
    std::map<std::pair<int, int>, float> heights;
    std::map<Cell, Mesh> world;
    Parts parts;
    for (int step = 0; step < 12; ++step) {
      for (int i = 0; i < 3; ++i)
        heights[{static_cast<int>(random() % 7) - 3, static_cast<int>(random() % 7) - 3}] =
            static_cast<float>(random() % 8) / 16;
      std::map<Cell, Mesh> update;
      for (int x = -3; x < 3; ++x)
        for (int y = -3; y < 3; ++y) {
          const Cell cell{x, y, 0};
          Mesh mesh = random() % 8 == 0 ? Mesh() : square(x, y, heights);
          if (random() % 3 == 0) continue;
          update[cell] = mesh;
          world[cell] = mesh;
        }
      std::vector<MapBlock> blocks;
      for (const auto& [cell, mesh] : update) blocks.push_back({cell, mesh});
      const auto change = splitter->update(blocks);
      ASSERT_TRUE(change);
      apply(*change, parts);
      auto fresh = Splitter::make(unit_cells(), options);
      blocks.clear();
      for (const auto& [cell, mesh] : world) blocks.push_back({cell, mesh});
      const auto whole = fresh->update(blocks);
      ASSERT_TRUE(whole);
      ASSERT_EQ(whole->changed.size(), parts.size());
      for (const ChangedPart& part : whole->changed) {
        const MapPart& ours = parts.at(part.part.key);
        EXPECT_EQ(ours.mesh.positions, part.part.mesh.positions);
        EXPECT_EQ(ours.mesh.triangles, part.part.mesh.triangles);
        EXPECT_EQ(ours.border, part.part.border);
      }
    }
  }
}

/// The border that each part has by definition.
std::map<PartKey, std::set<std::tuple<std::array<float, 3>, LatticePoint, std::uint32_t>>> borders_of(
    const Parts& parts, const MapLattice& lattice) {
  const auto position_of = [](const Mesh& mesh, std::size_t v) {
    return std::array{mesh.positions[3 * v], mesh.positions[3 * v + 1], mesh.positions[3 * v + 2]};
  };
  std::map<std::array<float, 3>, std::set<PartKey>> users;
  for (const auto& [key, part] : parts)
    for (std::size_t v = 0; v < part.mesh.vertex_count(); ++v) users[position_of(part.mesh, v)].insert(key);
  std::erase_if(users, [](const auto& entry) { return entry.second.size() < 2; });
  std::map<LatticePoint, std::uint32_t> twins;
  std::map<PartKey, std::set<std::tuple<std::array<float, 3>, LatticePoint, std::uint32_t>>> borders;
  for (const auto& [position, keys] : users) {  // positive coordinates: bits ascend as they do
    const LatticePoint point = lattice.nearest(position);
    const std::uint32_t twin = twins[point]++;
    for (const PartKey& key : keys) borders[key].emplace(position, point, twin);
  }
  return borders;
}

TEST(MapUpdate, MAP8BordersAreThePositionsOfSeveralPartsWhateverTheBlocks) {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    std::mt19937 random(seed);
    MapDescription description{.cell_steps = 4};
    description.lattice.step_exponent = seed % 2 == 0 ? -2 : 1;  // coarse: many positions at a point
    auto splitter = Splitter::make(description, {10 + 8 * (seed % 3), static_cast<std::uint8_t>(seed % 5)});
    ASSERT_TRUE(splitter);
    Parts parts;
    for (int step = 0; step < 15; ++step) {
      // Triangles of a few positions, wherever the block is.
      std::map<Cell, Mesh> meshes;
      for (int i = 0; i < 4; ++i) {
        Mesh& mesh = meshes[{static_cast<int>(random() % 4) - 1, static_cast<int>(random() % 4) - 1, 0}];
        mesh = {};
        const std::uint32_t corners = 3 * static_cast<std::uint32_t>(random() % 5);
        for (std::uint32_t v = 0; v < corners; ++v) {
          for (int k = 0; k < 3; ++k) mesh.positions.push_back(static_cast<float>(1 + random() % 4) / 2);
          mesh.triangles.push_back(v);
        }
      }
      std::vector<MapBlock> blocks;
      for (const auto& [cell, mesh] : meshes) blocks.push_back({cell, mesh});
      const auto change = splitter->update(blocks);
      ASSERT_TRUE(change);
      apply(*change, parts);
      auto expected = borders_of(parts, description.lattice);
      for (const auto& [key, part] : parts) {
        std::set<std::tuple<std::array<float, 3>, LatticePoint, std::uint32_t>> own;
        for (const BorderVertex& b : part.border) {
          const float* p = part.mesh.positions.data() + 3 * std::size_t{b.vertex};
          own.emplace(std::array{p[0], p[1], p[2]}, b.point, b.twin);
        }
        EXPECT_EQ(own, expected[key]) << seed << ' ' << step;
      }
    }
  }
}

TEST(MapUpdate, PartsThatStayAsTheyAreAreNotTold) {
  auto splitter = Splitter::make(unit_cells(), {.most_triangles = 8, .most_level = 3, .copy_level = 2});
  ASSERT_TRUE(splitter);
  std::mt19937 random(5);
  Parts parts;
  for (int step = 0; step < 40; ++step) {
    std::map<Cell, Mesh> meshes;
    for (int i = 0; i < 3; ++i) {
      const int x = static_cast<int>(random() % 8) - 4;
      const int y = static_cast<int>(random() % 8) - 4;
      meshes[{x, y, 0}] =
          random() % 5 == 0 ? Mesh() : square(x, y, {{{x, y}, static_cast<float>(random() % 4) / 8}});
    }
    std::vector<MapBlock> blocks;
    for (const auto& [cell, mesh] : meshes) blocks.push_back({cell, mesh});
    const auto change = splitter->update(blocks);
    ASSERT_TRUE(change);
    for (const ChangedPart& changed : change->changed) {
      const auto known = parts.find(changed.part.key);
      EXPECT_TRUE(known == parts.end() || known->second.mesh.positions != changed.part.mesh.positions ||
                  known->second.mesh.triangles != changed.part.mesh.triangles ||
                  known->second.border != changed.part.border ||
                  changed.part.key.level > 0);  // a copy of what it may have been made of before
    }
    apply(*change, parts);
  }
  EXPECT_GT(parts.size(), 10U);
}

TEST(MapUpdate, AnErrorLeavesTheMapAsItWas) {
  auto splitter = Splitter::make(unit_cells());
  ASSERT_TRUE(splitter);
  const Mesh mesh = square(0, 0, {});
  EXPECT_FALSE(splitter->update(std::vector<MapBlock>{{{0, 0, 0}, mesh}, {{0, 0, 0}, mesh}}));
  EXPECT_EQ(splitter->revision(), 0U);
  EXPECT_EQ(splitter->update({})->changed.size(), 0U);
}

}  // namespace
}  // namespace deltamesh
