// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What parts keep of colours is decided once for a whole map.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

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

TEST(MapColors, AHundredLabelMapsStayExactInParts) {
  int maps = 0;
  for (const std::uint32_t seed : {1U, 2U, 3U, 4U, 5U}) {
    for (const std::uint32_t count : {10U, 40U, 150U, 600U}) {
      for (const test::LabelMap& map : test::label_maps(seed, count)) {
        ++maps;
        const auto state = encode_map(map.mesh, settings_of(4000));
        ASSERT_TRUE(state.has_value()) << map.name;
        EXPECT_GE(state->octets.size(), 3U) << map.name;
        EXPECT_EQ(state->attributes.color_error, 0) << map.name;
        EXPECT_EQ(largest_color_error(state->manifest), 0) << map.name;
      }
    }
  }
  EXPECT_GE(maps, 100);
}

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
