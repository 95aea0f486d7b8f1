// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Colours of labels are told from those of photographs, and kept exactly where nothing is said of colours.
#include "deltamesh/color_content.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "scenes.h"
#include "support/label_maps.h"
#include "support/random.h"

namespace deltamesh {
namespace {

using test::LabelMap;

bool is_photographic(const Mesh& mesh) {
  ColorContent content;
  EXPECT_TRUE(content.add(mesh).has_value());
  return content.is_photographic();
}

Attribute colors_of(std::initializer_list<std::array<std::uint8_t, 3>> rows) {
  Attribute colors{.kind = AttributeKind::kColor, .type = ComponentType::kU8, .components = 3};
  for (const auto& row : rows)
    for (const std::uint8_t x : row) colors.values.push_back(std::byte{x});
  return colors;
}

/// `copies` triangles, each with these colours.
Mesh triangles(std::initializer_list<std::array<std::uint8_t, 3>> rows, std::uint32_t copies) {
  Mesh mesh;
  mesh.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  mesh.attributes = {colors_of(rows)};
  for (std::uint32_t i = 0; i < copies; ++i) mesh.triangles.insert(mesh.triangles.end(), {0, 1, 2});
  return mesh;
}

TEST(ColorContent, SharesOfEqualNearAndFarEdgesDecide) {
  EXPECT_TRUE(is_photographic(triangles({{10, 10, 10}, {10, 10, 18}, {10, 10, 26}}, 1000)));   // 2 near
  EXPECT_FALSE(is_photographic(triangles({{10, 10, 10}, {10, 10, 10}, {10, 10, 60}}, 1000)));  // none
  EXPECT_TRUE(
      is_photographic(triangles({{10, 10, 10}, {10, 10, 10}, {10, 10, 18}}, 1000)));  // 1 equal, 2 near
  EXPECT_FALSE(
      is_photographic(triangles({{10, 10, 10}, {10, 10, 18}, {10, 10, 60}}, 1000)));  // 1 near, 2 far
}

TEST(ColorContent, FewFacesAndNoColorsAreNoPhotographs) {
  ColorContent few;
  ASSERT_TRUE(few.add(triangles({{10, 10, 10}, {10, 10, 18}, {10, 10, 26}}, 999)).has_value());
  EXPECT_FALSE(few.is_photographic());
  EXPECT_FALSE(few.has_labels());
  EXPECT_EQ(few.complete({}).color_error, 0);
  EXPECT_FALSE(ColorContent().is_photographic());
  Mesh mesh = triangles({{10, 10, 10}, {10, 10, 18}, {10, 10, 26}}, 1000);
  mesh.attributes.clear();
  EXPECT_FALSE(is_photographic(mesh));
}

TEST(ColorContent, MeshesAddUp) {
  ColorContent content;
  for (int i = 0; i < 2; ++i) {
    EXPECT_FALSE(content.is_photographic());
    ASSERT_TRUE(content.add(triangles({{10, 10, 10}, {10, 10, 18}, {10, 10, 26}}, 500)).has_value());
  }
  EXPECT_TRUE(content.is_photographic());
  EXPECT_EQ(content.complete({}).color_rms, kPhotographicRms);
  EXPECT_EQ(content.complete({.color_error = 2}).color_rms, std::nullopt);
  EXPECT_EQ(content.complete({.color_rms = 5}).color_rms, 5);
  EXPECT_EQ(ColorContent().complete({}).color_error, 0);
}

TEST(ColorContent, OneAttributeOfLabelsIsEnough) {
  Mesh mesh = triangles({{10, 10, 10}, {10, 10, 18}, {10, 10, 26}}, 1000);
  mesh.attributes.push_back(colors_of({{10, 10, 10}, {10, 10, 10}, {10, 10, 60}}));
  EXPECT_FALSE(is_photographic(mesh));
}

TEST(ColorContent, RefusesColorsOfOtherSizes) {
  Mesh mesh = triangles({{10, 10, 10}, {10, 10, 18}, {10, 10, 26}}, 1);
  mesh.attributes[0].values.pop_back();
  EXPECT_FALSE(ColorContent().add(mesh).has_value());
  mesh = triangles({{10, 10, 10}, {10, 10, 18}, {10, 10, 26}}, 1);
  mesh.triangles[0] = 3;
  EXPECT_FALSE(ColorContent().add(mesh).has_value());
}

TEST(ColorContent, AHundredLabelMapsStayExact) {
  int maps = 0;
  for (const std::uint32_t seed : {1U, 2U, 3U, 4U, 5U}) {
    for (const std::uint32_t count : {10U, 40U, 150U, 600U}) {
      for (const LabelMap& map : test::label_maps(seed, count)) {
        ++maps;
        const auto encoded = encode(map.mesh, {.geometry = GeometryCoder::kPredictive, .effort = 0});
        ASSERT_TRUE(encoded.has_value()) << map.name;
        EXPECT_EQ(encoded->report.stream.attributes.at(0).error, 0) << map.name;
        EXPECT_GE(encoded->report.labels, 2U) << map.name;
      }
    }
  }
  EXPECT_GE(maps, 100);
}

/// Smooth waves with grain on rooms.
Mesh textured(std::uint64_t seed, double grain, double wave) {
  Mesh mesh = *generate_scene(Scene::kRooms, 6000, seed);
  test::RandomBits random(11);
  Attribute& colors = mesh.attributes.at(0);
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const float* p = &mesh.positions[3 * v];
    for (std::size_t c = 0; c < 3; ++c) {
      const double smooth = std::sin(wave * double{p[0]} + static_cast<double>(c)) +
                            std::sin(wave * double{p[1]}) * std::cos(double{p[2]});
      const double noise = grain * ((random() % 1024) / 512.0 - 1);
      colors.values[v * colors.components + c] =
          static_cast<std::byte>(static_cast<std::uint8_t>(128 + 40 * smooth + noise));
    }
  }
  return mesh;
}

TEST(ColorContent, TexturesAreBounded) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    for (const double grain : {1.0, 5.0, 10.0}) {
      for (const double wave : {0.5, 1.0, 2.0}) {
        const auto encoded = encode(textured(seed, grain, wave), {.effort = 0});
        ASSERT_TRUE(encoded.has_value());
        const AttributeInfo& colors = encoded->report.stream.attributes.at(0);
        EXPECT_GT(colors.rms, 0) << seed << " " << grain << " " << wave;
        EXPECT_LE(colors.rms, 1.001 * kPhotographicRms) << seed << " " << grain << " " << wave;
        EXPECT_EQ(encoded->report.labels, 0U);
      }
    }
  }
}

TEST(ColorContent, WhatIsAskedForIsDone) {
  const Mesh mesh = textured(1, 5, 1);
  const auto error_of = [&](EncodeOptions options) {
    options.effort = 0;
    return encode(mesh, options)->report.stream.attributes.at(0).error;
  };
  EXPECT_EQ(error_of({.lossless = true}), 0);
  EXPECT_EQ(error_of({.attributes = {.color_error = 0}}), 0);
  EXPECT_EQ(error_of({.attributes = {.color_error = 3}}), 3);
  EXPECT_LE(error_of({.profile = Profile::kZstd}), 2);
}

TEST(ColorContent, LabelsStayExactWithinAsFewBytesAsCanBe) {
  const LabelMap map = test::label_maps(1, 40).front();
  const auto encoded = encode(map.mesh, {.quality = {.target_bytes = 20000}, .effort = 0});
  ASSERT_TRUE(encoded.has_value());
  EXPECT_EQ(encoded->report.stream.attributes.at(0).error, 0);
}

}  // namespace
}  // namespace deltamesh
