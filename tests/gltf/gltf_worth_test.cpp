// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Meshes that packing would not make smaller stay as they are.
#include <gtest/gtest.h>

#include "deltamesh/gltf.h"
#include "gltf_packing.h"
#include "support/gltf_asset.h"

namespace deltamesh::gltf_worth_test {
namespace {

using test::Bytes;
using test::GltfBuilder;
using test::Json;
using test::make_sheet;
using test::OpenedGlb;
using test::pack_ok;

/// Many meshes that show one sheet, each with a material of its own.
GltfBuilder many_of_one(int meshes) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(6));
  const Json first = builder.json["meshes"][0];
  builder.json["meshes"] = Json::array();
  builder.json["nodes"] = Json::array();
  for (int i = 0; i < meshes; ++i) {
    builder.push("materials", {{"name", "m" + std::to_string(i)}});
    Json mesh = first;
    mesh["primitives"][0]["material"] = i;
    builder.push("nodes", {{"mesh", builder.push("meshes", mesh)}});
  }
  return builder;
}

TEST(GltfWorth, AnAssetStaysAsItIsWherePackingDoesNotPay) {
  const GltfBuilder builder = many_of_one(100);
  const Bytes asset = builder.glb();
  const GltfOutput packed = pack_ok(asset);
  EXPECT_EQ(packed.report.converted, 0U);
  EXPECT_EQ(packed.report.not_smaller, 100U);
  EXPECT_EQ(packed.report.streams, 0U);
  EXPECT_LE(packed.asset.size(), asset.size());
  const OpenedGlb kept(packed.asset);
  EXPECT_EQ(kept.json["meshes"], builder.json["meshes"]);
  EXPECT_FALSE(kept.json.contains("extensionsUsed"));
  EXPECT_EQ(test::positions_of(kept, kept.primitive()), make_sheet(6).positions);
}

TEST(GltfWorth, OtherMeshesOfTheAssetArePacked) {
  GltfBuilder builder = many_of_one(100);
  builder.sheet_mesh(make_sheet(20));
  const GltfOutput packed = pack_ok(builder.glb());
  EXPECT_EQ(packed.report.converted, 1U);
  EXPECT_EQ(packed.report.not_smaller, 100U);
  const OpenedGlb opened(packed.asset);
  EXPECT_FALSE(opened.primitive(0).contains("extensions"));
  EXPECT_TRUE(opened.primitive(100).contains("extensions"));
  EXPECT_EQ(test::positions_of(opened, opened.primitive(0)), make_sheet(6).positions);
}

TEST(GltfWorth, FewMeshesOfOneSheetArePacked) {
  const GltfOutput packed = pack_ok(many_of_one(3).glb());
  EXPECT_EQ(packed.report.converted, 3U);
  EXPECT_LT(packed.report.output_bytes, packed.report.input_bytes);
}

TEST(GltfWorth, BytesOfAnimationsAndImagesAreTold) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(20));
  const std::size_t times = builder.floats({0, 1, 2}, 1, true, 0);
  const std::size_t turns = builder.floats(std::vector<float>(12, 0.5F), 4, false, 0);
  const Json sampler{{"input", times}, {"output", turns}};
  builder.push("nodes", {{"mesh", 0}});
  builder.push("animations",
               {{"samplers", {sampler, sampler}},
                {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "rotation"}}}}}}});
  const std::size_t pixels = builder.view(Bytes(1000));
  builder.push("images", {{"bufferView", pixels}, {"mimeType", "image/png"}});
  builder.push("images", {{"bufferView", pixels}, {"mimeType", "image/png"}});
  builder.push("images", {{"uri", "data:image/png;base64,AAAA"}});
  builder.push("images", {{"uri", "beside.png"}});
  const GltfReport packed = pack_ok(builder.glb()).report;
  EXPECT_EQ(packed.animation_bytes, 3 * 4U + 12 * 4U);
  EXPECT_EQ(packed.image_bytes, 1000U + 26U);
}

TEST(GltfWorth, WhoAsksForAFallbackGetsAllStreams) {
  EXPECT_EQ(pack_ok(many_of_one(100).glb(), test::with_fallback()).report.converted, 100U);
}

}  // namespace
}  // namespace deltamesh::gltf_worth_test
