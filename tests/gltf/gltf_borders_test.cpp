// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Scenes cut into meshes: what they have in common stays in common.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "deltamesh/gltf.h"
#include "gltf_packing.h"
#include "support/gltf_asset.h"

namespace deltamesh::gltf_borders_test {
namespace {

using test::GltfBuilder;
using test::Json;
using test::make_sheet;
using test::OpenedGlb;
using test::pack_ok;
using test::Sheet;
using test::unpack_ok;

constexpr std::uint32_t kEdge = 9;  // vertices along a chunk

/// The part of a bumpy plain that begins at (column, row), in chunks.
Sheet chunk(std::uint32_t column, std::uint32_t row) {
  Sheet sheet = make_sheet(kEdge);
  for (std::uint32_t v = 0; v < kEdge * kEdge; ++v) {
    const auto x = static_cast<float>(column * (kEdge - 1) + v % kEdge);
    const auto y = static_cast<float>(row * (kEdge - 1) + v / kEdge);
    const std::array<float, 3> place{0.3F * x, 0.7F * y, 0.2F * std::sin(x) + 0.3F * std::cos(1.7F * y)};
    std::copy(place.begin(), place.end(), sheet.positions.begin() + 3 * v);
  }
  return sheet;
}

GltfBuilder plain_of(std::uint32_t columns, std::uint32_t rows) {
  GltfBuilder builder;
  for (std::uint32_t row = 0; row < rows; ++row)
    for (std::uint32_t column = 0; column < columns; ++column) builder.sheet_mesh(chunk(column, row));
  return builder;
}

/// How many positions each two meshes have in common.
std::vector<std::size_t> borders_of(const OpenedGlb& glb) {
  std::vector<std::set<std::array<float, 3>>> places;
  for (std::size_t mesh = 0; mesh < glb.json["meshes"].size(); ++mesh) {
    const auto positions = test::positions_of(glb, glb.primitive(mesh));
    std::set<std::array<float, 3>>& own = places.emplace_back();
    for (std::size_t i = 0; i < positions.size(); i += 3)
      own.insert({positions[i], positions[i + 1], positions[i + 2]});
  }
  std::vector<std::size_t> borders;
  for (std::size_t a = 0; a < places.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      std::size_t& common = borders.emplace_back(0);
      for (const auto& place : places[a]) common += places[b].count(place);
    }
  return borders;
}

void expect_whole(const GltfBuilder& builder, const GltfPackOptions& options) {
  const GltfOutput packed = pack_ok(builder.glb(), options);
  EXPECT_EQ(packed.report.converted, builder.json["meshes"].size());
  EXPECT_EQ(borders_of(OpenedGlb(unpack_ok(packed.asset).asset)), borders_of(OpenedGlb(builder.glb())));
}

TEST(GltfBorders, StayTogetherAtEverySetting) {
  const GltfBuilder builder = plain_of(2, 1);
  ASSERT_EQ(borders_of(OpenedGlb(builder.glb())), std::vector<std::size_t>{kEdge});
  const auto percent = [](double value) {
    return QualityBound{.value = value, .unit = QualityUnit::kDiagonal};
  };
  std::vector<EncodeOptions> settings(12);
  settings[1].quality.max_error = QualityBound{0.003};
  settings[2].quality.max_error = percent(0.5);
  settings[3].quality.lfe = percent(0.05);
  settings[4].quality.vde = percent(0.2);
  settings[5].quality = {.vde = percent(0.5), .max_error = percent(1)};
  settings[6].bits = 9;
  settings[7].step = 0.01;
  settings[8].geometry = GeometryCoder::kHighpass;
  settings[9].geometry = GeometryCoder::kPredictive;
  settings[10].lossless = true;
  settings[11].keep_order = settings[11].keep_unreferenced = true;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    SCOPED_TRACE(i);
    GltfPackOptions options;
    options.encode = settings[i];
    options.encode.effort = 0;
    expect_whole(builder, options);
  }
}

TEST(GltfBorders, KeepTheBoundThatIsAskedFor) {
  GltfPackOptions options;
  options.encode.quality.max_error = QualityBound{0.003};
  const GltfOutput packed = pack_ok(plain_of(3, 3).glb(), options);
  EXPECT_EQ(packed.report.streams, 9U);
  EXPECT_LE(packed.report.max_error, 0.003);
  EXPECT_GT(packed.report.max_error, 0.002);
}

TEST(GltfBorders, OfNineMeshesAndUnderNodesWithOneTransform) {
  GltfBuilder builder = plain_of(3, 3);
  expect_whole(builder, {});
  for (Json& node : builder.json["nodes"]) node["translation"] = {4, 5, 6};
  expect_whole(builder, {});
}

TEST(GltfBorders, OfAHundredMeshes) {
  GltfBuilder builder = plain_of(10, 10);
  GltfPackOptions options;
  options.encode.effort = 0;
  expect_whole(builder, options);
  for (Json& node : builder.json["nodes"]) node["scale"] = {2, 2, -1};
  options.encode.quality.max_error = QualityBound{0.003};
  expect_whole(builder, options);
}

TEST(GltfBorders, MeshesElsewhereAreCodedEachOnItsOwn) {
  GltfBuilder apart = plain_of(2, 1);
  apart.json["nodes"][1]["translation"] = {4, 5, 6};
  GltfBuilder alone;
  alone.sheet_mesh(chunk(0, 0));
  const GltfOutput both = pack_ok(apart.glb());
  ASSERT_EQ(both.report.stream_reports.size(), 2U);
  EXPECT_EQ(both.report.stream_reports[0].info.bytes, pack_ok(alone.glb()).report.stream_bytes);
}

TEST(GltfPack, BoundsOnTextureCoordinatesCountBehindTextureTransforms) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(12));
  Json& primitive = builder.json["meshes"][0]["primitives"][0];
  primitive["material"] = 0;
  const auto error_with = [&](const Json& material) {
    builder.json["materials"] = Json::array({material});
    return pack_ok(builder.glb()).report.attributes;
  };
  const auto uv_error = [](const std::vector<GltfAttributeReport>& attributes) {
    double error = 0;
    for (const GltfAttributeReport& attribute : attributes)
      if (attribute.kind == AttributeKind::kUv) error = attribute.error;
    return error;
  };
  const Json scaled{{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"scale", {50, -20}}}}}}};
  EXPECT_GT(uv_error(error_with(Json::object())), 1.0 / 4096 / 50);
  EXPECT_LE(uv_error(error_with({{"pbrMetallicRoughness", {{"baseColorTexture", scaled}}}})),
            1.0 / 4096 / 50);
  EXPECT_LE(
      uv_error(error_with({{"extensions", {{"KHR_materials_sheen", {{"sheenColorTexture", scaled}}}}}})),
      1.0 / 4096 / 50);
  builder.json["materials"] = Json::array({Json::object()});
  primitive["extensions"]["KHR_materials_variants"]["mappings"] =
      Json::array({Json{{"material", 1}, {"variants", {0}}}});
  builder.json["materials"].push_back({{"normalTexture", scaled}});
  EXPECT_LE(uv_error(pack_ok(builder.glb()).report.attributes), 1.0 / 4096 / 50);
}

}  // namespace
}  // namespace deltamesh::gltf_borders_test
