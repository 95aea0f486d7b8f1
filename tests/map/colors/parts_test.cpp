// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What parts keep of colours is decided once for a whole map.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "attributes/colors/fields.h"
#include "attributes/values.h"
#include "deltamesh/map/encode_map.h"
#include "deltamesh/map/map_codec.h"
#include "deltamesh/map/split.h"
#include "deltamesh/map/tiles.h"
#include "scenes.h"
#include "support/label_maps.h"

namespace deltamesh {
namespace {

MapSettings settings_of(std::uint32_t most_triangles) {
  MapSettings settings{.part_edge = 4, .most_triangles = most_triangles};
  settings.quality.bounds.max_error = QualityBound{0.02};
  settings.quality.geometry = GeometryCoder::kPredictive;
  settings.quality.effort = 0;
  return settings;
}

float largest_color_error(const MapManifest& manifest) {
  float most = 0;
  for (const PartEntry& entry : manifest.entries) most = std::max(most, entry.attribute_errors.at(0));
  return most;
}

/// By seed.
class LabelMapsInParts : public testing::TestWithParam<std::uint32_t> {};

TEST_P(LabelMapsInParts, StayExact) {
  int maps = 0;
  for (const std::uint32_t count : {10U, 40U, 150U, 600U}) {
    for (const test::LabelMap& map : test::label_maps(GetParam(), count)) {
      ++maps;
      const auto state = encode_map(map.mesh, settings_of(4000));
      ASSERT_TRUE(state.has_value()) << map.name;
      EXPECT_GE(state->octets.size(), 3U) << map.name;
      EXPECT_EQ(state->attributes.color_error, 0) << map.name;
      EXPECT_EQ(largest_color_error(state->manifest), 0) << map.name;
    }
  }
  EXPECT_GE(maps, 20);
}

// A hundred maps in all.
INSTANTIATE_TEST_SUITE_P(Seeds, LabelMapsInParts, testing::Range(1U, 6U));

TEST(MapColors, PartsOfPhotographsAreAllBounded) {
  const Mesh mesh = *generate_scene(Scene::kRooms, 6000, 1);
  const auto state = encode_map(mesh, settings_of(500));
  ASSERT_TRUE(state.has_value());
  EXPECT_EQ(state->attributes.color_rms, kPhotographicRms);
  EXPECT_GE(state->octets.size(), 10U);
  EXPECT_GT(largest_color_error(state->manifest), 0);
}

TEST(MapColors, TilesAreDecidedForTogether) {
  const Mesh mesh = *generate_scene(Scene::kRooms, 6000, 1);
  auto planner = TilePlanner::make(settings_of(500), 2000);
  ASSERT_TRUE(planner.has_value());
  ASSERT_TRUE(planner->add(mesh).has_value());
  EXPECT_EQ(planner->plan()->quality.attributes.color_rms, kPhotographicRms);
  ASSERT_TRUE(planner->add(test::label_maps(1, 40, 60000).front().mesh).has_value());
  EXPECT_EQ(planner->plan()->quality.attributes.color_error, 0);
}

/// How many copies of border vertices have another colour than one before, and how many have none before.
struct Seams {
  std::size_t differing = 0;
  std::size_t vertices = 0;
  std::size_t copies = 0;
};
Seams seams_of(const MapState& state) {
  Seams seams;
  const auto codec = MapCodec::open(state.manifest.description);
  std::map<std::pair<LatticePoint, std::uint32_t>, std::vector<std::byte>> known;
  for (std::size_t i = 0; i < state.octets.size(); ++i) {
    const auto part = codec->decode(state.manifest.entries[i].key, state.octets[i]);
    if (!part) {
      ADD_FAILURE() << part.error().message;
      continue;
    }
    const Attribute& colors = part->mesh.attributes.at(0);
    const std::size_t size = colors.components * component_size(colors.type);
    for (const BorderVertex& b : part->border) {
      const auto begin = colors.values.begin() + static_cast<std::ptrdiff_t>(b.vertex * size);
      const std::vector<std::byte> color(begin, begin + static_cast<std::ptrdiff_t>(size));
      const auto [place, is_new] = known.try_emplace({b.point, b.twin}, color);
      ++seams.copies;
      seams.vertices += is_new ? 1 : 0;
      seams.differing += place->second != color ? 1 : 0;
    }
  }
  return seams;
}

Mesh rooms_of(ComponentType type) {
  Mesh mesh = *generate_scene(Scene::kRooms, 6000, 1);
  Attribute& colors = mesh.attributes.at(0);
  const std::size_t size = component_size(type);
  std::vector<std::byte> values(colors.values.size() * size);
  for (std::size_t i = 0; i < colors.values.size(); ++i)
    store_component(&values[i * size], size,
                    color_of_level(type, 8, std::to_integer<std::int32_t>(colors.values[i])));
  colors.type = type;
  colors.values = std::move(values);
  return mesh;
}

TEST(MapColors, MAP24CopiesOfBorderVerticesHaveOneColour) {
  const AttributeQuality bounded{.color_error = 4};
  const AttributeQuality half{.color_error = 0.6};
  const AttributeQuality coarse{.color_rms = 12};
  for (const ComponentType type : {ComponentType::kU8, ComponentType::kU16, ComponentType::kF32}) {
    const Mesh mesh = rooms_of(type);
    for (const AttributeQuality& quality : {AttributeQuality{}, bounded, half, coarse}) {
      MapSettings settings = settings_of(500);
      settings.quality.attributes = quality;
      const auto state = encode_map(mesh, settings);
      ASSERT_TRUE(state.has_value());
      const Seams seams = seams_of(*state);
      EXPECT_GT(seams.copies, seams.vertices + 300);
      EXPECT_EQ(seams.differing, 0U);
      if (quality.color_error) {
        EXPECT_LE(largest_color_error(state->manifest), *quality.color_error);
      }
    }
  }
}

TEST(MapColors, APartAloneIsExact) {
  const Mesh mesh = *generate_scene(Scene::kRooms, 6000, 1);
  MapDescription description{.lattice = {.step_exponent = -8}, .cell_steps = 1024};
  for (const Attribute& a : mesh.attributes)
    description.attributes.push_back({a.kind, a.type, a.components, a.normalized, a.name, a.linear});
  const auto parts = split(mesh, description);
  ASSERT_TRUE(parts.has_value());
  const auto codec = MapCodec::open(description);
  const auto coded = codec->encode(parts->front(), {.bounds = {.max_error = QualityBound{0.02}}});
  ASSERT_TRUE(coded.has_value());
  EXPECT_EQ(coded->attribute_errors.at(0), 0);
}

}  // namespace
}  // namespace deltamesh
