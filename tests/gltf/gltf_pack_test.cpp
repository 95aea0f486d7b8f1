// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What packing does to an asset, seen from outside: through the packed JSON, and through unpacking again.
#include <gtest/gtest.h>

#include <string>

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

TEST(GltfPack, LeavesListsOfNoWholeTrianglesAsTheyAre) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(10));
  const auto indices = builder.json["meshes"][0]["primitives"][0]["indices"].get<std::size_t>();
  Json& count = builder.json["accessors"][indices]["count"];
  count = count.get<std::size_t>() - 1;
  const GltfReport report = pack_ok(builder.glb()).report;
  EXPECT_EQ(report.converted, 0U);
  EXPECT_EQ(report.not_triangles, 1U);
}

TEST(GltfPack, CompressesASheetAndBringsItBack) {
  GltfBuilder builder;
  const Sheet sheet = make_sheet(40);
  builder.sheet_mesh(sheet);
  const Bytes asset = builder.glb();
  const GltfOutput packed = pack_ok(asset);
  EXPECT_EQ(packed.report.primitives, 1U);
  EXPECT_EQ(packed.report.converted, 1U);
  EXPECT_EQ(packed.report.streams, 1U);
  EXPECT_EQ(packed.report.vertices, 1600U);
  EXPECT_EQ(packed.report.triangles, 39U * 39 * 2);
  EXPECT_EQ(packed.report.input_bytes, asset.size());
  EXPECT_EQ(packed.report.output_bytes, packed.asset.size());
  EXPECT_LT(packed.asset.size() * 4, asset.size());

  const OpenedGlb small(packed.asset);
  EXPECT_EQ(small.json["extensionsUsed"], Json::array({kExtension}));
  EXPECT_EQ(small.json["extensionsRequired"], Json::array({kExtension}));
  const Json& primitive = small.primitive();
  const Json& extension = primitive["extensions"][kExtension];
  EXPECT_EQ(extension["attributes"], (Json{{"NORMAL", 0}, {"TEXCOORD_0", 1}}));
  EXPECT_EQ(small.json["bufferViews"].size(), 1U);
  EXPECT_EQ(packed.report.stream_bytes, small.view(extension["bufferView"]).size());
  for (const Json& accessor : small.json["accessors"]) EXPECT_FALSE(accessor.contains("bufferView"));

  const GltfOutput unpacked = unpack_ok(packed.asset);
  EXPECT_EQ(unpacked.report.converted, 1U);
  const OpenedGlb plain(unpacked.asset);
  EXPECT_FALSE(plain.json.contains("extensionsUsed"));
  EXPECT_FALSE(plain.json.contains("extensionsRequired"));
  EXPECT_FALSE(plain.primitive().contains("extensions"));
  EXPECT_EQ(positions_of(plain, plain.primitive()).size(), sheet.positions.size());
  EXPECT_NEAR(signed_area(plain, plain.primitive()), 2.0, 2e-2);
}

TEST(GltfPack, GLTF8FallbackAccessorsHoldExactlyWhatTheStreamDecodesTo) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(20));
  const GltfOutput packed = pack_ok(builder.glb(), with_fallback());
  const OpenedGlb both(packed.asset);
  EXPECT_EQ(both.json["extensionsUsed"], Json::array({kExtension}));
  EXPECT_FALSE(both.json.contains("extensionsRequired"));
  const Json& primitive = both.primitive();
  const auto stream = both.view(primitive["extensions"][kExtension]["bufferView"]);
  const auto mesh = decode(stream);
  ASSERT_TRUE(mesh);
  EXPECT_EQ(positions_of(both, primitive), mesh->positions);
  EXPECT_EQ(bytes_of(both.values<float>(primitive["attributes"]["NORMAL"])), mesh->attributes[0].values);
  EXPECT_EQ(bytes_of(both.values<float>(primitive["attributes"]["TEXCOORD_0"])), mesh->attributes[1].values);
  const auto indices = both.values<std::uint16_t>(primitive["indices"]);
  EXPECT_EQ(std::vector<std::uint32_t>(indices.begin(), indices.end()), mesh->triangles);
  // Unpacking drops the stream and leaves the same data.
  const OpenedGlb plain(unpack_ok(packed.asset).asset);
  EXPECT_EQ(positions_of(plain, plain.primitive()), mesh->positions);
  EXPECT_FALSE(plain.primitive().contains("extensions"));
}

TEST(GltfPack, GLTF10BoundsAreThoseOfTheDecodedData) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(20));
  const GltfOutput packed = pack_ok(builder.glb());
  const OpenedGlb small(packed.asset);
  const Json& primitive = small.primitive();
  const auto mesh = decode(small.view(primitive["extensions"][kExtension]["bufferView"]));
  ASSERT_TRUE(mesh);
  const Json& bounds = small.json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
  for (std::size_t k = 0; k < 3; ++k) {
    float low = mesh->positions[k];
    float high = low;
    for (std::size_t i = k; i < mesh->positions.size(); i += 3) {
      low = std::min(low, mesh->positions[i]);
      high = std::max(high, mesh->positions[i]);
    }
    EXPECT_EQ(bounds["min"][k].get<float>(), low);
    EXPECT_EQ(bounds["max"][k].get<float>(), high);
  }
}

TEST(GltfPack, SameInputSameBytes) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(15));
  const Bytes asset = builder.glb();
  EXPECT_EQ(pack_ok(asset).asset, pack_ok(asset).asset);
}

/// Everything that glTF has beside geometry, some of it with data of its own.
GltfBuilder rich_asset() {
  GltfBuilder builder;
  builder.json["asset"]["generator"] = "by hand";
  builder.json["asset"]["extras"] = {
      {"pi", 3.141592653589793}, {"big", 9007199254740993}, {"deep", {1, {2.5, nullptr}}}};
  const std::size_t mesh = builder.sheet_mesh(make_sheet(12));
  const std::size_t vertices = 144;
  Json& primitive = builder.json["meshes"][mesh]["primitives"][0];
  std::vector<std::uint8_t> joints(vertices * 4);
  std::vector<float> weights(vertices * 4);
  for (std::size_t i = 0; i < vertices; ++i) {
    joints[4 * i] = static_cast<std::uint8_t>(i % 2);
    weights[4 * i] = 1;
  }
  const std::size_t joint_view = builder.view(bytes_of(joints), 34962);
  primitive["attributes"]["JOINTS_0"] = builder.push(
      "accessors",
      {{"bufferView", joint_view}, {"componentType", 5121}, {"count", vertices}, {"type", "VEC4"}});
  primitive["attributes"]["WEIGHTS_0"] = builder.floats(weights, 4);
  primitive["attributes"]["_TEMPERATURE"] = builder.floats(std::vector<float>(vertices, 21.5F), 1);
  primitive["material"] = 0;
  primitive["extras"] = {{"kept", true}, {"bufferView", 99}};
  builder.push("materials",
               {{"name", "red"},
                {"pbrMetallicRoughness", {{"baseColorFactor", {0.1, 0.2, 0.30000000000000004, 1}}}},
                {"extensions", {{"KHR_materials_ior", {{"ior", 1.4}}}}}});
  builder.json["extensionsUsed"] = {"KHR_materials_ior", "X_unknown"};

  std::vector<float> matrices;
  for (int i = 0; i < 2; ++i)
    for (int k = 0; k < 16; ++k) matrices.push_back(k % 5 == 0 ? 1.0F : 0.0F);
  const std::size_t matrix_view = builder.view(bytes_of(matrices));
  const std::size_t inverse = builder.push(
      "accessors", {{"bufferView", matrix_view}, {"componentType", 5126}, {"count", 2}, {"type", "MAT4"}});
  builder.json["nodes"][0]["skin"] = 0;
  builder.push("nodes", {{"name", "joint 1"}, {"translation", {0, 0.5, 0}}});
  builder.push("nodes", {{"name", "joint 2"},
                         {"extensions", {{"X_unknown", {{"text", "kept"}, {"data", {{"bufferView", 0}}}}}}}});
  builder.push("skins", {{"inverseBindMatrices", inverse}, {"joints", {1, 2}}});

  const std::size_t times = builder.floats({0, 1, 2}, 1, true, 0);
  const std::size_t moves = builder.floats({0, 0, 0, 0, 1, 0, 0, 2, 0}, 3, false, 0);
  builder.push("animations",
               {{"name", "move"},
                {"samplers", Json::array({Json{{"input", times}, {"output", moves}}})},
                {"channels",
                 Json::array({Json{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}})}});
  builder.push("images", {{"bufferView", builder.view(bytes_of(std::string("not really a picture")))},
                          {"mimeType", "image/png"}});
  builder.push("images", {{"uri", "textures/wood%20grain.png"}});
  builder.json["extras"] = "the end";
  return builder;
}

/// The asset without what packing may change.
Json without_geometry(Json json) {
  for (const char* key : {"buffers", "bufferViews", "accessors"}) json.erase(key);
  for (Json& mesh : json["meshes"])
    for (Json& primitive : mesh["primitives"])
      for (const char* key : {"attributes", "indices"}) primitive.erase(key);
  json["images"][0].erase("bufferView");
  json["nodes"][2]["extensions"]["X_unknown"]["data"].erase("bufferView");
  return json;
}

TEST(GltfPack, EverythingElseIsUnchangedDownToMemberOrder) {
  const GltfBuilder builder = rich_asset();
  const Bytes asset = builder.glb();
  const OpenedGlb before(asset);
  for (const bool fallback : {false, true}) {
    GltfPackOptions options;
    options.fallback = fallback;
    const GltfOutput packed = pack_ok(asset, options);
    const OpenedGlb after(unpack_ok(packed.asset).asset);
    EXPECT_EQ(without_geometry(after.json).dump(), without_geometry(before.json).dump());
    EXPECT_EQ(packed.report.streams, 1U);

    const OpenedGlb middle(packed.asset);
    for (const OpenedGlb* glb : {&middle, &after}) {
      EXPECT_EQ(glb->view(glb->json["images"][0]["bufferView"]),
                bytes_of(std::string("not really a picture")));
      const Json& sampler = glb->json["animations"][0]["samplers"][0];
      EXPECT_EQ(glb->values<float>(sampler["input"]), (std::vector<float>{0, 1, 2}));
      EXPECT_EQ(glb->values<float>(sampler["output"]), (std::vector<float>{0, 0, 0, 0, 1, 0, 0, 2, 0}));
      EXPECT_EQ(glb->json["skins"][0]["inverseBindMatrices"], before.json["skins"][0]["inverseBindMatrices"]);
      const auto data =
          glb->json["nodes"][2]["extensions"]["X_unknown"]["data"]["bufferView"].get<std::size_t>();
      EXPECT_EQ(glb->view(data), before.view(0));
    }
    // Joints, weights and application data come back exactly, whatever the order.
    const Json& attributes = after.primitive()["attributes"];
    EXPECT_EQ(after.values<float>(attributes["_TEMPERATURE"]), std::vector<float>(144, 21.5F));
    const auto joints = after.values<std::uint8_t>(attributes["JOINTS_0"]);
    EXPECT_EQ(std::count(joints.begin(), joints.end(), 1), 72);
    const auto weights = after.values<float>(attributes["WEIGHTS_0"]);
    EXPECT_EQ(std::count(weights.begin(), weights.end(), 1.0F), 144);
  }
}

TEST(GltfPack, GLTF9LeavesWhatItCannotCompressOrOthersDid) {
  GltfBuilder builder;
  const std::size_t words = builder.push("accessors", {{"bufferView", builder.view(Bytes(36), 34962)},
                                                       {"componentType", 5125},
                                                       {"count", 3},
                                                       {"type", "VEC3"}});
  const std::size_t empty = builder.push(
      "accessors",
      {{"componentType", 5126}, {"count", 3}, {"type", "VEC3"}, {"min", {0, 0, 0}}, {"max", {0, 0, 0}}});
  const std::size_t triangle = builder.floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, 3, true);
  Json primitives = Json::array();
  primitives.push_back({{"attributes", {{"POSITION", words}}}});
  primitives.push_back({{"attributes", {{"POSITION", empty}}}});
  primitives.push_back({{"attributes", {{"POSITION", triangle}}}, {"mode", 3}});
  primitives.push_back({{"attributes", {{"_ID", triangle}}}});
  primitives.push_back(
      {{"attributes", {{"POSITION", triangle}}},
       {"extensions",
        {{"KHR_draco_mesh_compression", {{"bufferView", 0}, {"attributes", {{"POSITION", 0}}}}}}}});
  builder.push("meshes", {{"primitives", primitives}});
  const GltfOutput packed = pack_ok(builder.glb());
  EXPECT_EQ(packed.report.primitives, 5U);
  EXPECT_EQ(packed.report.converted, 0U);
  EXPECT_EQ(packed.report.not_float_positions, 1U);
  EXPECT_EQ(packed.report.otherwise_compressed, 2U);
  EXPECT_EQ(packed.report.not_triangles, 2U);
  const OpenedGlb same(packed.asset);
  EXPECT_EQ(same.json["meshes"][0]["primitives"], primitives);
  EXPECT_FALSE(same.json.contains("extensionsUsed"));
  EXPECT_EQ(same.values<float>(triangle), (std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}));
}

TEST(GltfPack, PackingTwiceChangesNothingMore) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(8));
  const GltfOutput once = pack_ok(builder.glb());
  const GltfOutput twice = pack_ok(once.asset);
  EXPECT_EQ(twice.report.otherwise_compressed, 1U);
  EXPECT_EQ(twice.asset, once.asset);
}

TEST(GltfPack, TinyMeshesWork) {
  GltfBuilder builder;
  const std::size_t triangle = builder.floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, 3, true);
  const std::size_t point = builder.floats({2, 2, 2, 2, 2, 2, 2, 2, 2}, 3, true);  // a degenerate triangle
  builder.push("meshes", {{"primitives", Json::array({Json{{"attributes", {{"POSITION", triangle}}}},
                                                      Json{{"attributes", {{"POSITION", point}}}}})}});
  const GltfOutput packed = pack_ok(builder.glb(), with_fallback());
  EXPECT_EQ(packed.report.converted, 2U);
  const OpenedGlb plain(unpack_ok(packed.asset).asset);
  EXPECT_NEAR(signed_area(plain, plain.primitive(0, 0)), 1.0, 1e-2);
  const auto positions = positions_of(plain, plain.primitive(0, 1));
  for (const std::uint16_t corner : plain.values<std::uint16_t>(plain.primitive(0, 1)["indices"]))
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(positions[corner * 3U + k], 2, 1e-3);
}

TEST(GltfPack, UnreferencedVerticesAreDroppedUnlessAskedFor) {
  GltfBuilder builder;
  const std::size_t position = builder.floats({9, 9, 9, 0, 0, 0, 1, 0, 0, 0, 1, 0, 8, 8, 8}, 3, true);
  builder.push("meshes", {{"primitives", Json::array({Json{{"attributes", {{"POSITION", position}}},
                                                           {"indices", builder.indices({1, 2, 3})}}})}});
  const GltfOutput packed = pack_ok(builder.glb(), with_fallback());
  EXPECT_EQ(packed.report.unreferenced_vertices, 2U);
  EXPECT_EQ(packed.report.vertices, 3U);
  EXPECT_EQ(packed.report.welded_vertices, 0U);
  EXPECT_EQ(OpenedGlb(packed.asset).json["accessors"][position]["count"], 3);
  GltfPackOptions options = with_fallback();
  options.encode.keep_unreferenced = true;
  EXPECT_EQ(pack_ok(builder.glb(), options).report.vertices, 5U);
}

TEST(GltfPack, JsonWithItsBufferBesideItOrEmbeddedIsTheSameAsset) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(8));
  const GltfOutput glb = pack_ok(builder.glb());
  GltfIo io;
  io.resolve = [&](std::string_view) -> Result<Bytes> { return builder.bin; };
  io.container = GltfContainer::kGltf;
  const GltfOutput embedded = pack_ok(builder.gltf("mesh.bin"), {}, io);
  EXPECT_TRUE(embedded.buffer.empty());
  io.buffer_uri = "packed.bin";
  const GltfOutput beside = pack_ok(builder.gltf("mesh.bin"), {}, io);
  EXPECT_EQ(beside.report.output_bytes, beside.asset.size() + beside.buffer.size());
  EXPECT_EQ(beside.report.input_bytes, builder.gltf("mesh.bin").size() + builder.bin.size());

  GltfIo packed_io;
  packed_io.resolve = [&](std::string_view uri) -> Result<Bytes> {
    EXPECT_EQ(uri, "packed.bin");
    return beside.buffer;
  };
  const Bytes plain = unpack_ok(glb.asset).asset;
  const auto from_embedded = unpack_gltf(embedded.asset);
  const auto from_beside = unpack_gltf(beside.asset, {}, packed_io);
  ASSERT_TRUE(from_embedded);
  ASSERT_TRUE(from_beside);
  EXPECT_EQ(from_embedded->asset, plain);
  EXPECT_EQ(from_beside->asset, plain);
}

TEST(GltfPack, ReportsProgressOfTheWholeAsset) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(8));
  builder.sheet_mesh(make_sheet(9));
  double last = 0;
  GltfPackOptions options;
  options.encode.progress = [&](double share) {
    EXPECT_GE(share, last);
    EXPECT_LE(share, 1);
    last = share;
  };
  pack_ok(builder.glb(), options);
  EXPECT_GT(last, 0.5);
}

}  // namespace
}  // namespace deltamesh
