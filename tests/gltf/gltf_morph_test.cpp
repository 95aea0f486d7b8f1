// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Morph targets and skins: what goes into the stream and comes back, within which bounds.
#include <gtest/gtest.h>

#include "asset_compare.h"
#include "deltamesh/gltf.h"
#include "gltf_packing.h"
#include "support/gltf_asset.h"

namespace deltamesh {
namespace {

using test::Bytes;
using test::bytes_of;
using test::distance;
using test::floats_of;
using test::for_each_vertex;
using test::GltfBuilder;
using test::Json;
using test::kExtension;
using test::make_sheet;
using test::OpenedGlb;
using test::pack_ok;
using test::Sheet;
using test::unpack_ok;
using test::with_ids;

constexpr std::size_t kSide = 16;

/// A sheet with two targets: the first moves positions, normals and tangents, the second positions only.
GltfBuilder morphing_sheet() {
  GltfBuilder builder;
  const Sheet sheet = make_sheet(kSide);
  builder.sheet_mesh(sheet);
  std::vector<float> rise(sheet.positions.size());
  std::vector<float> turn(sheet.positions.size());
  std::vector<float> tangents;
  for (std::size_t i = 0; i < rise.size(); i += 3) {
    rise[i + 2] = 0.3F * sheet.positions[i] * sheet.positions[i + 1];
    turn[i] = 0.2F * sheet.positions[i];
    turn[i + 1] = -0.1F * sheet.positions[i + 1];
    tangents.insert(tangents.end(), {1, 0, 0, 1});
  }
  Json& primitive = builder.json["meshes"][0]["primitives"][0];
  primitive["attributes"]["TANGENT"] = builder.floats(tangents, 4);
  const std::size_t turned = builder.floats(turn, 3, true);
  primitive["targets"] =
      Json::array({Json{{"POSITION", builder.floats(rise, 3, true)}, {"NORMAL", turned}, {"TANGENT", turned}},
                   Json{{"POSITION", turned}}});
  builder.json["meshes"][0]["weights"] = {0.5, 0};
  return builder;
}

/// Largest distance of every attribute between the assets, which have ids.
std::map<std::string, double> distances(const OpenedGlb& before, const OpenedGlb& after) {
  std::map<std::string, double> largest;
  for_each_vertex(before, before.primitive(), after, after.primitive(),
                  [&](const std::string& name, const Bytes& from, const Bytes& to) {
                    largest[name] = std::max(largest[name], distance(from, to));
                  });
  return largest;
}

TEST(GltfMorph, TargetsGoIntoTheStream) {
  const GltfOutput packed = pack_ok(morphing_sheet().glb());
  const OpenedGlb small(packed.asset);
  const Json& extension = small.primitive()["extensions"][kExtension];
  EXPECT_EQ(extension["attributes"].size(), 3U);
  ASSERT_EQ(extension["targets"].size(), 2U);
  EXPECT_EQ(extension["targets"][0].size(), 3U);
  EXPECT_EQ(extension["targets"][1].size(), 1U);
  EXPECT_EQ(small.json["bufferViews"].size(), 1U);
  const OpenedGlb plain(unpack_ok(packed.asset).asset);
  for (const Json& target : plain.primitive()["targets"])
    EXPECT_TRUE(plain.json["accessors"][target["POSITION"].get<std::size_t>()].contains("min"));
  EXPECT_EQ(plain.json["meshes"][0]["weights"], Json::array({0.5, 0}));
}

TEST(GltfMorph, DisplacementsKeepTheBoundsOfWhatTheyDisplace) {
  const Bytes asset = with_ids(OpenedGlb(morphing_sheet().glb()));
  GltfPackOptions options;
  options.encode.quality.max_error = QualityBound{.value = 0.1, .unit = QualityUnit::kDiagonal};
  options.encode.attributes.normal_error = 1;
  options.encode.attributes.tangent_error = 2;
  const GltfOutput packed = pack_ok(asset, options);
  const auto largest = distances(OpenedGlb(asset), OpenedGlb(unpack_ok(packed.asset).asset));
  const double bound = 0.001 * packed.report.stream_reports.at(0).info.diagonal;
  for (const char* name : {"POSITION", "0 POSITION", "1 POSITION"})
    EXPECT_LE(largest.at(name), bound) << name;
  EXPECT_LE(largest.at("0 NORMAL"), 0.01746);
  EXPECT_LE(largest.at("0 TANGENT"), 0.03492);
}

TEST(GltfMorph, BoundsByNameWinAndZeroIsExact) {
  const Bytes asset = with_ids(OpenedGlb(morphing_sheet().glb()));
  GltfPackOptions options;
  options.encode.attributes.named = {{"POSITION", 0}, {"NORMAL", 0}, {"TANGENT", 0}};
  const GltfOutput packed = pack_ok(asset, options);
  const auto largest = distances(OpenedGlb(asset), OpenedGlb(unpack_ok(packed.asset).asset));
  for (const char* name : {"0 POSITION", "1 POSITION", "0 NORMAL", "0 TANGENT"})
    EXPECT_EQ(largest.at(name), 0) << name;
}

TEST(GltfMorph, WithoutABoundOnPositionsTheirErrorIsTheBound) {
  const Bytes asset = with_ids(OpenedGlb(morphing_sheet().glb()));
  GltfPackOptions options;
  options.encode.bits = 8;
  const GltfOutput packed = pack_ok(asset, options);
  const auto largest = distances(OpenedGlb(asset), OpenedGlb(unpack_ok(packed.asset).asset));
  EXPECT_GT(packed.report.max_error, 0);
  EXPECT_LE(largest.at("0 POSITION"), packed.report.max_error);
}

TEST(GltfMorph, SparseTargetsWithoutAViewAreRead) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(kSide));
  const std::size_t index_view = builder.view(bytes_of(std::vector<std::uint16_t>{3, 77}));
  const std::size_t value_view = builder.view(bytes_of(std::vector<float>{0, 0, 1, 0.5F, 0, 0}));
  const Json zero{{"componentType", 5126}, {"count", kSide * kSide}, {"type", "VEC3"}};
  Json sparse = zero;
  sparse["min"] = {0, 0, 0};
  sparse["max"] = {0.5, 0, 1};
  sparse["sparse"] = {{"count", 2},
                      {"indices", {{"bufferView", index_view}, {"componentType", 5123}}},
                      {"values", {{"bufferView", value_view}}}};
  Json& primitive = builder.json["meshes"][0]["primitives"][0];
  primitive["targets"] = Json::array(
      {Json{{"POSITION", builder.push("accessors", sparse)}, {"NORMAL", builder.push("accessors", zero)}}});
  GltfPackOptions options;
  options.encode.lossless = true;
  options.encode.keep_order = true;
  const GltfOutput packed = pack_ok(builder.glb(), options);
  EXPECT_EQ(packed.report.converted, 1U);
  const OpenedGlb plain(unpack_ok(packed.asset).asset);
  const Json& target = plain.primitive()["targets"][0];
  std::vector<float> expected(kSide * kSide * 3);
  expected[3 * 3 + 2] = 1;
  expected[77 * 3] = 0.5F;
  EXPECT_EQ(plain.values<float>(target["POSITION"]), expected);
  EXPECT_EQ(plain.values<float>(target["NORMAL"]), std::vector<float>(kSide * kSide * 3));
  for (const Json& accessor : plain.json["accessors"]) EXPECT_FALSE(accessor.contains("sparse"));
}

TEST(GltfMorph, AHundredTargetsAreNotTooMany) {
  GltfBuilder builder;
  const Sheet sheet = make_sheet(5);
  builder.sheet_mesh(sheet);
  Json targets = Json::array();
  for (int i = 0; i < 100; ++i)
    targets.push_back({{"POSITION", builder.floats(std::vector<float>(75, float(i)), 3, true)}});
  builder.json["meshes"][0]["primitives"][0]["targets"] = targets;
  const GltfOutput packed = pack_ok(builder.glb());
  const OpenedGlb plain(unpack_ok(packed.asset).asset);
  for (int i = 0; i < 100; ++i)
    for (const float x : plain.values<float>(plain.primitive()["targets"][i]["POSITION"]))
      EXPECT_NEAR(x, i, 0.01);
}

TEST(GltfMorph, SkinsComeBack) {
  GltfBuilder builder;
  const Sheet sheet = make_sheet(kSide);
  builder.sheet_mesh(sheet);
  const std::size_t vertices = kSide * kSide;
  std::vector<std::uint16_t> joints(vertices * 4);
  std::vector<float> weights(vertices * 4);
  Bytes byte_weights(vertices * 4);
  for (std::size_t i = 0; i < vertices; ++i) {
    joints[4 * i] = static_cast<std::uint16_t>(i % 5);
    joints[4 * i + 1] = 300;
    weights[4 * i] = sheet.positions[3 * i];
    weights[4 * i + 1] = 1 - weights[4 * i];
    byte_weights[4 * i] = static_cast<std::byte>(i % 256);
    byte_weights[4 * i + 1] = static_cast<std::byte>(255 - i % 256);
  }
  Json& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
  const auto add = [&](const char* name, const Bytes& bytes, int type, bool normalized) {
    attributes[name] = builder.push("accessors", {{"bufferView", builder.view(bytes, 34962)},
                                                  {"componentType", type},
                                                  {"normalized", normalized},
                                                  {"count", vertices},
                                                  {"type", "VEC4"}});
  };
  add("JOINTS_0", bytes_of(joints), 5123, false);
  attributes["WEIGHTS_0"] = builder.floats(weights, 4);
  add("JOINTS_1", Bytes(vertices * 4, std::byte{2}), 5121, false);
  add("WEIGHTS_1", byte_weights, 5121, true);
  const Bytes asset = with_ids(OpenedGlb(builder.glb()));
  GltfPackOptions options;
  options.encode.attributes.weight_error = 0.01;
  const GltfOutput packed = pack_ok(asset, options);
  ASSERT_EQ(packed.report.stream_reports.size(), 1U);
  std::map<std::string, AttributeKind> kinds;
  for (const auto& attribute : packed.report.attributes) kinds[attribute.semantic] = attribute.kind;
  EXPECT_EQ(kinds["JOINTS_0"], AttributeKind::kJoints);
  EXPECT_EQ(kinds["JOINTS_1"], AttributeKind::kJoints);
  EXPECT_EQ(kinds["WEIGHTS_0"], AttributeKind::kWeights);
  EXPECT_EQ(kinds["WEIGHTS_1"], AttributeKind::kWeights);
  const OpenedGlb before(asset);
  const OpenedGlb after(unpack_ok(packed.asset).asset);
  for_each_vertex(before, before.primitive(), after, after.primitive(),
                  [&](const std::string& name, const Bytes& from, const Bytes& to) {
                    if (name.starts_with("JOINTS")) {
                      EXPECT_EQ(from, to) << name;
                    }
                    if (name == "WEIGHTS_0") {
                      for (std::size_t k = 0; k < 4; ++k)
                        EXPECT_NEAR(floats_of(from)[k], floats_of(to)[k], 0.01);
                    }
                  });
}

}  // namespace
}  // namespace deltamesh
