// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Coarser copies: no cracks between parts of any levels, and what is closed in the source is closed on all.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "deltamesh/map/encode_map.h"
#include "deltamesh/map/join.h"
#include "deltamesh/map/map_codec.h"
#include "deltamesh/map/split.h"
#include "map/map_covers.h"
#include "map/map_meshes.h"

namespace deltamesh {
namespace {

using test::attributes_of;

/// A closed bumpy surface of 2 n^2 faces with colours, about 2 across.
Mesh bumpy_torus(std::uint32_t n, bool has_groups) {
  Mesh mesh;
  Attribute color{AttributeKind::kColor, ComponentType::kU8, 3, true, "red", {}};
  const auto angle = [&](std::uint32_t i) { return 2 * std::numbers::pi * i / n; };
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      const double tube = 0.3 + 0.01 * std::sin(7 * angle(i)) * std::cos(5 * angle(j));
      const double radius = 0.7 + tube * std::cos(angle(j));
      for (const double x :
           {radius * std::cos(angle(i)), radius * std::sin(angle(i)), tube * std::sin(angle(j))})
        mesh.positions.push_back(static_cast<float>(x));
      for (std::uint32_t k = 0; k < 3; ++k)
        color.values.push_back(static_cast<std::byte>(100 + 50 * k + i % 4));
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = i * n + j;
      const std::uint32_t b = i * n + (j + 1) % n;
      const std::uint32_t c = (i + 1) % n * n + j;
      const std::uint32_t d = (i + 1) % n * n + (j + 1) % n;
      for (const std::uint32_t v : {a, b, c, b, d, c}) mesh.triangles.push_back(v);
      if (has_groups) mesh.face_groups.insert(mesh.face_groups.end(), {i / 9 % 3, i / 9 % 3});
    }
  }
  mesh.attributes.push_back(std::move(color));
  return mesh;
}

using test::chosen;
using test::keys_of;
using test::odd_edges;
using test::random_cover;

/// Where nothing is left of a cell there is nothing to make a coarser copy of.
TEST(MapLevels, MAP19IslandsVanish) {
  Mesh mesh = bumpy_torus(30, false);
  const auto first = static_cast<std::uint32_t>(mesh.vertex_count());
  mesh.positions.insert(mesh.positions.end(), {30, 30, 1, 30.01F, 30, 1, 30, 30.01F, 1});
  mesh.triangles.insert(mesh.triangles.end(), {first, first + 1, first + 2});
  mesh.attributes[0].values.resize(mesh.attributes[0].values.size() + 9);
  MapSettings settings{.part_edge = 0.5, .most_triangles = 500, .levels = 3};
  settings.quality.bounds.max_error = QualityBound{0.01};
  const auto state = encode_map(mesh, settings);
  ASSERT_TRUE(state) << describe(state.error());
  const auto finest = decode_map(*state);
  ASSERT_TRUE(finest);
  EXPECT_EQ(finest->triangle_count(), mesh.triangle_count());
}

TEST(MapLevels, MAP19WhatIsClosedIsClosedOnAllLevelsAndBetweenThem) {
  for (const bool has_groups : {false, true}) {
    const Mesh mesh = bumpy_torus(60, has_groups);
    MapDescription description{.cell_steps = 150, .attributes = attributes_of(mesh)};
    const auto parts = split(mesh, description, {.most_triangles = 400, .most_level = 2, .copy_level = 4});
    ASSERT_TRUE(parts);
    const auto codec = MapCodec::open(description);
    std::mt19937 random(1);
    std::vector<MapPart> decoded;
    for (const MapPart& part : *parts) {
      EXPECT_LE(part.mesh.triangle_count(), 400U);
      const PartQuality quality{
          .bounds = {.max_error = QualityBound{0.002 * static_cast<double>(1 + random() % 5)}},
          .geometry = random() % 2 == 0 ? GeometryCoder::kPredictive : GeometryCoder::kAuto,
          .effort = 0};
      const auto coded = codec->encode(part, quality);
      ASSERT_TRUE(coded) << describe(coded.error());
      decoded.push_back(*codec->decode(part.key, coded->bytes));
    }
    std::size_t before = mesh.triangle_count() + 1;
    for (std::uint8_t level = 0; level <= 4; ++level) {
      const auto keys = keys_on_level(keys_of(*parts), level);
      ASSERT_FALSE(keys.empty());
      const auto joined = join(chosen(decoded, keys));
      ASSERT_TRUE(joined);
      EXPECT_EQ(odd_edges(*joined), 0U) << int{level};
      EXPECT_LT(joined->triangle_count(), before);
      if (level > 1) before = joined->triangle_count();
    }
    EXPECT_LT(before, mesh.triangle_count() / 4);
    for (int i = 0; i < 20; ++i)
      EXPECT_EQ(odd_edges(*join(chosen(decoded, random_cover(decoded, random)))), 0U);
  }
}

TEST(MapLevels, MAP19BordersStayWhateverTheMesh) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    const Mesh mesh =
        seed % 2 == 0 ? test::wavy_sheet(50, 50, seed, 0.002) : test::random_mesh(seed, 200, 900);
    MapDescription description{.cell_steps = 100, .attributes = attributes_of(mesh)};
    const auto parts = split(mesh, description, {.most_triangles = 100000, .most_level = 0, .copy_level = 3});
    ASSERT_TRUE(parts);
    // A position is a border position of a copy just where faces outside of its cell have it.
    for (const MapPart& part : *parts) {
      std::set<std::pair<LatticePoint, std::uint32_t>> own;
      for (const BorderVertex& border : part.border) own.emplace(border.point, border.twin);
      std::set<std::pair<LatticePoint, std::uint32_t>> common;
      std::set<std::pair<LatticePoint, std::uint32_t>> inside;
      for (const MapPart& other : *parts) {
        if (other.key.level != 0) continue;
        for (const BorderVertex& border : other.border)
          (overlap(other.key, part.key) ? inside : common).emplace(border.point, border.twin);
      }
      std::erase_if(common, [&](const auto& vertex) { return !inside.contains(vertex); });
      EXPECT_EQ(own, common);
    }
  }
}

TEST(MapLevels, LevelsOfAMap) {
  const std::vector<PartKey> keys = {{0, 0, 0, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}, {1, 1, 0, 0}, {2, 0, 0, 0}};
  EXPECT_EQ(keys_on_level(keys, 0), (std::vector<PartKey>{keys[0], keys[1], keys[3]}));
  EXPECT_EQ(keys_on_level(keys, 1), (std::vector<PartKey>{keys[2], keys[3]}));
  EXPECT_EQ(keys_on_level(keys, 2), (std::vector<PartKey>{keys[4]}));
  EXPECT_TRUE(keys_on_level(keys, 3).empty());
  EXPECT_TRUE(keys_on_level({}, 0).empty());
  EXPECT_EQ(top_level(keys), 2);
  EXPECT_EQ(top_level(std::span(keys).first(4)), 1);
  EXPECT_EQ(top_level(std::vector<PartKey>{keys[0], keys[3]}), 0);  // a part without a copy on level 1
  EXPECT_EQ(top_level(std::span(keys).last(2)), 2);
  EXPECT_EQ(top_level({}), 0);
}

TEST(MapLevels, AWholeMeshAsAMapWithLevels) {
  const Mesh mesh = bumpy_torus(80, false);
  MapSettings settings{.part_edge = 0.5, .most_triangles = 1000, .levels = 2};
  settings.quality.bounds.max_error = QualityBound{0.002};
  settings.quality.effort = 0;
  const auto state = encode_map(mesh, settings);
  ASSERT_TRUE(state) << describe(state.error());
  EXPECT_EQ(test::topology_counts(*decode_map(*state)), test::topology_counts(mesh));
  const auto coarse = decode_map(*state, {}, 5);
  ASSERT_TRUE(coarse);
  EXPECT_EQ(odd_edges(*coarse), 0U);
  EXPECT_EQ(decode_map(*state, {}, 6).error().code, ErrorCode::kInvalidArgument);
  EXPECT_LT(coarse->triangle_count(), mesh.triangle_count() / 8);
  for (const PartEntry& entry : state->manifest.entries) {
    EXPECT_LE(entry.quality.max_error, entry.key.level < 4 ? 0.05 : 0.3);
    for (const PartLink& link : entry.links) EXPECT_FALSE(overlap(link.key, entry.key));
  }
  settings.levels = 22;
  EXPECT_EQ(encode_map(mesh, settings).error().code, ErrorCode::kInvalidArgument);
}

}  // namespace
}  // namespace deltamesh
