// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How packing takes the accessors of every kind apart, and leaves those that others need.
#include <gtest/gtest.h>

#include "deltamesh/gltf.h"
#include "gltf_packing.h"
#include "support/gltf_asset.h"

namespace deltamesh {
namespace {

using test::Bytes;
using test::bytes_of;
using test::GltfBuilder;
using test::Json;
using test::kExtension;
using test::make_sheet;
using test::OpenedGlb;
using test::pack_ok;
using test::positions_of;
using test::Sheet;
using test::signed_area;
using test::unpack_ok;
using test::with_fallback;

TEST(GltfPack, AttributesMayHaveTheNamesOfReferences) {
  GltfBuilder builder;
  const std::size_t mesh = builder.sheet_mesh(make_sheet(6));
  Json& attributes = builder.json["meshes"][mesh]["primitives"][0]["attributes"];
  for (const char* name : {"buffer", "bufferView"}) attributes[name] = attributes["POSITION"];
  const GltfOutput packed = pack_ok(builder.glb(), with_fallback());
  EXPECT_EQ(packed.report.converted, 1U);
  EXPECT_EQ(unpack_ok(packed.asset).report.converted, 1U);
  EXPECT_EQ(unpack_ok(pack_ok(builder.glb()).asset).report.converted, 1U);
}

TEST(GltfPack, NonIndexedTrianglesGetIndices) {
  GltfBuilder builder;
  const Sheet sheet = make_sheet(6);
  std::vector<float> soup;
  for (const std::uint32_t corner : sheet.triangles)
    soup.insert(soup.end(), &sheet.positions[corner * 3], &sheet.positions[corner * 3] + 3);
  const std::size_t position = builder.floats(soup, 3, true);
  builder.push("meshes", {{"primitives", Json::array({Json{{"attributes", {{"POSITION", position}}}}})}});
  const OpenedGlb plain(unpack_ok(pack_ok(builder.glb()).asset).asset);
  EXPECT_EQ(plain.json["accessors"].size(), 2U);
  EXPECT_NEAR(signed_area(plain, plain.primitive()), 2.0, 5e-2);
}

TEST(GltfPack, EqualPrimitivesShareAStream) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(8));
  builder.json["meshes"].push_back(builder.json["meshes"][0]);
  builder.push("nodes", {{"mesh", 1}});
  const GltfOutput packed = pack_ok(builder.glb());
  EXPECT_EQ(packed.report.converted, 2U);
  EXPECT_EQ(packed.report.streams, 1U);
  const OpenedGlb small(packed.asset);
  EXPECT_EQ(small.primitive(0), small.primitive(1));
  const OpenedGlb plain(unpack_ok(packed.asset).asset);
  EXPECT_EQ(plain.primitive(0), plain.primitive(1));
}

TEST(GltfPack, AccessorsThatOthersUseKeepTheirData) {
  GltfBuilder builder;
  const Sheet sheet = make_sheet(8);
  builder.sheet_mesh(sheet);
  Json points = builder.json["meshes"][0]["primitives"][0];
  points["mode"] = 0;
  points.erase("indices");
  builder.json["meshes"][0]["primitives"].push_back(points);
  const GltfOutput packed = pack_ok(builder.glb());
  EXPECT_EQ(packed.report.not_triangles, 1U);
  const OpenedGlb small(packed.asset);
  EXPECT_EQ(small.primitive(0, 1), points);
  EXPECT_EQ(positions_of(small, small.primitive(0, 1)), sheet.positions);
  EXPECT_NE(small.primitive(0, 0)["attributes"]["POSITION"], points["attributes"]["POSITION"]);
}

TEST(GltfPack, NumbersInUnknownExtensionsProtectAccessorsAndOrder) {
  GltfBuilder builder;
  const Sheet sheet = make_sheet(8);
  builder.sheet_mesh(sheet);
  Json& primitive = builder.json["meshes"][0]["primitives"][0];
  primitive["extensions"]["X_outline"] = {{"indices", primitive["indices"]}};
  const OpenedGlb small(pack_ok(builder.glb(), with_fallback()).asset);
  EXPECT_EQ(small.values<std::uint32_t>(small.primitive()["extensions"]["X_outline"]["indices"]),
            sheet.triangles);
  const auto indices = small.values<std::uint16_t>(small.primitive()["indices"]);
  EXPECT_EQ(std::vector<std::uint32_t>(indices.begin(), indices.end()), sheet.triangles);
}

TEST(GltfPack, SparseAndInterleavedAccessorsAreResolved) {
  GltfBuilder builder;
  Sheet sheet = make_sheet(6);
  std::vector<float> interleaved;
  for (std::size_t i = 0; i < 36; ++i) {
    interleaved.insert(interleaved.end(), &sheet.positions[3 * i], &sheet.positions[3 * i] + 3);
    interleaved.insert(interleaved.end(), &sheet.uvs[2 * i], &sheet.uvs[2 * i] + 2);
  }
  const std::size_t view = builder.view(bytes_of(interleaved), 34962);
  builder.json["bufferViews"][view]["byteStride"] = 20;
  const std::size_t index_view = builder.view(bytes_of(std::vector<std::uint8_t>{0, 35}));
  const std::size_t value_view = builder.view(bytes_of(std::vector<float>{-3, 0, 0, 1, 1, 5}));
  const std::size_t position =
      builder.push("accessors", {{"bufferView", view},
                                 {"componentType", 5126},
                                 {"count", 36},
                                 {"type", "VEC3"},
                                 {"min", {-3, 0, -1}},
                                 {"max", {1, 1, 5}},
                                 {"sparse",
                                  {{"count", 2},
                                   {"indices", {{"bufferView", index_view}, {"componentType", 5121}}},
                                   {"values", {{"bufferView", value_view}}}}}});
  const std::size_t uv = builder.push(
      "accessors",
      {{"bufferView", view}, {"byteOffset", 12}, {"componentType", 5126}, {"count", 36}, {"type", "VEC2"}});
  builder.push("meshes",
               {{"primitives", Json::array({Json{{"attributes", {{"POSITION", position}, {"TEXCOORD_0", uv}}},
                                                 {"indices", builder.indices(sheet.triangles)}}})}});
  GltfPackOptions options;
  options.encode.bits = 14;
  options.encode.attributes.uv_error = 1e-5;
  options.encode.keep_order = true;
  const OpenedGlb plain(unpack_ok(pack_ok(builder.glb(), options).asset).asset);
  sheet.positions[0] = -3;
  sheet.positions[1] = 0;
  sheet.positions[2] = 0;
  sheet.positions[35 * 3 + 2] = 5;
  const auto positions = positions_of(plain, plain.primitive());
  const auto uvs = plain.values<float>(plain.primitive()["attributes"]["TEXCOORD_0"]);
  ASSERT_EQ(positions.size(), sheet.positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) EXPECT_NEAR(positions[i], sheet.positions[i], 0.02) << i;
  for (std::size_t i = 0; i < uvs.size(); ++i) EXPECT_NEAR(uvs[i], sheet.uvs[i], 1e-5) << i;
  for (const Json& accessor : plain.json["accessors"]) EXPECT_FALSE(accessor.contains("sparse"));
}

TEST(GltfPack, ColoursOfEveryTypeStayWhatTheyAre) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(6));
  Json& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
  std::vector<std::uint8_t> bytes(36 * 4);
  std::vector<std::uint16_t> words(36 * 4);
  std::vector<float> floats(36 * 3);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * 7);
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = static_cast<std::uint16_t>(i * 451);
  for (std::size_t i = 0; i < floats.size(); ++i) floats[i] = static_cast<float>(i) / 108.0F;
  const std::size_t byte_view = builder.view(bytes_of(bytes), 34962);
  const std::size_t word_view = builder.view(bytes_of(words), 34962);
  builder.json["bufferViews"][byte_view]["byteStride"] = 4;
  attributes["COLOR_0"] = builder.push("accessors", {{"bufferView", byte_view},
                                                     {"componentType", 5121},
                                                     {"normalized", true},
                                                     {"count", 36},
                                                     {"type", "VEC3"}});
  attributes["COLOR_1"] = builder.push("accessors", {{"bufferView", word_view},
                                                     {"componentType", 5123},
                                                     {"normalized", true},
                                                     {"count", 36},
                                                     {"type", "VEC4"}});
  attributes["COLOR_2"] = builder.floats(floats, 3);
  GltfPackOptions options;
  options.encode.keep_order = true;
  const OpenedGlb plain(unpack_ok(pack_ok(builder.glb(), options).asset).asset);
  const Json& after = plain.primitive()["attributes"];
  const auto colours = plain.values<std::uint8_t>(after["COLOR_0"]);
  for (std::size_t i = 0; i < 36; ++i)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(colours[3 * i + k], bytes[4 * i + k]);
  const auto deep = plain.values<std::uint16_t>(after["COLOR_1"]);
  for (std::size_t i = 0; i < deep.size(); ++i) EXPECT_NEAR(deep[i], words[i], 130);
  const auto real = plain.values<float>(after["COLOR_2"]);
  for (std::size_t i = 0; i < real.size(); ++i) EXPECT_NEAR(real[i], floats[i], 1.0 / 500);
  EXPECT_EQ(plain.json["accessors"][after["COLOR_0"].get<std::size_t>()]["normalized"], true);
}

TEST(GltfPack, MatricesAreCodedUnlessTheirColumnsArePadded) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(6));
  std::vector<float> frames(36 * 9);
  for (std::size_t i = 0; i < frames.size(); ++i) frames[i] = static_cast<float>(i);
  Json& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
  const std::size_t view = builder.view(bytes_of(frames), 34962);
  attributes["_FRAME"] = builder.push(
      "accessors", {{"bufferView", view}, {"componentType", 5126}, {"count", 36}, {"type", "MAT3"}});
  GltfPackOptions options;
  options.encode.keep_order = true;
  const OpenedGlb plain(unpack_ok(pack_ok(builder.glb(), options).asset).asset);
  const Json& frame = plain.json["accessors"][plain.primitive()["attributes"]["_FRAME"].get<std::size_t>()];
  EXPECT_EQ(frame["type"], "MAT3");
  EXPECT_EQ(plain.view(frame["bufferView"]), bytes_of(frames));

  const Bytes padded(36 * 12, std::byte{7});
  const std::size_t padded_view = builder.view(padded, 34962);
  attributes["_SMALL"] = builder.push(
      "accessors", {{"bufferView", padded_view}, {"componentType", 5121}, {"count", 36}, {"type", "MAT3"}});
  const OpenedGlb small(pack_ok(builder.glb(), with_fallback()).asset);
  EXPECT_FALSE(small.primitive()["extensions"][kExtension]["attributes"].contains("_SMALL"));
  EXPECT_TRUE(small.primitive()["extensions"][kExtension]["attributes"].contains("_FRAME"));
  const std::size_t kept = small.primitive()["attributes"]["_SMALL"];
  EXPECT_EQ(small.view(small.json["accessors"][kept]["bufferView"]), padded);
  const auto indices = small.values<std::uint16_t>(small.primitive()["indices"]);
  EXPECT_EQ(std::vector<std::uint32_t>(indices.begin(), indices.end()), make_sheet(6).triangles);
}

}  // namespace
}  // namespace deltamesh
