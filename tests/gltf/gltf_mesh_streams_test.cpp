// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What primitives share: one stream for each mesh, vertices, groups, and no cracks between them.
#include <gtest/gtest.h>

#include <random>

#include "asset_compare.h"
#include "deltamesh/gltf.h"
#include "gltf_packing.h"
#include "support/gltf_asset.h"

namespace deltamesh {
namespace {

using test::Bytes;
using test::bytes_of;
using test::expect_no_cracks;
using test::expect_same_soups;
using test::GltfBuilder;
using test::Json;
using test::kExtension;
using test::lossless;
using test::make_sheet;
using test::OpenedGlb;
using test::pack_ok;
using test::Sheet;
using test::unpack_ok;
using test::with_ids;

/// Adds a mesh: a sheet in two primitives that share accessors.
void add_split_sheet(GltfBuilder& builder) {
  Sheet sheet = make_sheet(10);
  const std::vector<std::uint32_t> rest(sheet.triangles.begin() + 240, sheet.triangles.end());
  sheet.triangles.resize(240);
  const std::size_t mesh = builder.sheet_mesh(sheet);
  Json& primitives = builder.json["meshes"][mesh]["primitives"];
  Json second = primitives[0];
  second["indices"] = builder.indices(rest);
  primitives.push_back(second);
}

GltfBuilder split_sheet() {
  GltfBuilder builder;
  add_split_sheet(builder);
  return builder;
}

/// A sheet in three primitives with vertices of their own: strips of rows that share borders. The first has
/// normals and texture coordinates, the second neither, the third normals and colours of bytes.
GltfBuilder patchwork() {
  GltfBuilder builder;
  const std::uint32_t n = 13;
  const Sheet sheet = make_sheet(n);
  Json primitives = Json::array();
  for (std::uint32_t part = 0; part < 3; ++part) {
    const std::uint32_t first = part * 4 * n;  // five rows, four of quads
    const auto slice = [&](const std::vector<float>& values, std::size_t components) {
      const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first * components);
      return std::vector<float>(begin, begin + static_cast<std::ptrdiff_t>(5 * n * components));
    };
    std::vector<std::uint32_t> triangles(
        sheet.triangles.begin(), sheet.triangles.begin() + static_cast<std::ptrdiff_t>(4 * (n - 1) * 6));
    Json attributes{{"POSITION", builder.floats(slice(sheet.positions, 3), 3, true)}};
    if (part != 1) attributes["NORMAL"] = builder.floats(slice(sheet.normals, 3), 3);
    if (part == 0) attributes["TEXCOORD_0"] = builder.floats(slice(sheet.uvs, 2), 2);
    if (part == 2) {
      Bytes colours(5 * n * 4);
      for (std::size_t i = 0; i < colours.size(); ++i) colours[i] = static_cast<std::byte>(i % 251);
      attributes["COLOR_0"] = builder.push("accessors", {{"bufferView", builder.view(colours, 34962)},
                                                         {"componentType", 5121},
                                                         {"normalized", true},
                                                         {"count", 5 * n},
                                                         {"type", "VEC4"}});
    }
    primitives.push_back({{"attributes", attributes}, {"indices", builder.indices(triangles)}});
  }
  builder.push("nodes", {{"mesh", builder.push("meshes", {{"primitives", primitives}})}});
  return builder;
}

TEST(GltfMeshStreams, PrimitivesOfAMeshShareAStreamAndVertices) {
  const GltfBuilder builder = split_sheet();
  const GltfOutput packed = pack_ok(builder.glb(), lossless());
  EXPECT_EQ(packed.report.streams, 1U);
  EXPECT_EQ(packed.report.converted, 2U);
  EXPECT_EQ(packed.report.vertices, 100U);
  EXPECT_EQ(packed.report.unreferenced_vertices, 0U);
  const OpenedGlb small(packed.asset);
  const Json& first = small.primitive(0, 0);
  const Json& second = small.primitive(0, 1);
  EXPECT_EQ(first["attributes"], second["attributes"]);
  EXPECT_NE(first["indices"], second["indices"]);
  EXPECT_FALSE(first["extensions"][kExtension].contains("group"));
  EXPECT_EQ(second["extensions"][kExtension]["group"], 1);
  EXPECT_EQ(small.json["bufferViews"].size(), 1U);
  expect_same_soups(OpenedGlb(builder.glb()), OpenedGlb(unpack_ok(packed.asset).asset));
}

TEST(GltfMeshStreams, AttributesThatOnlySomePrimitivesHaveComeBackToThose) {
  const GltfBuilder builder = patchwork();
  const GltfOutput packed = pack_ok(builder.glb(), lossless());
  EXPECT_EQ(packed.report.streams, 1U);
  const OpenedGlb small(packed.asset);
  EXPECT_EQ(small.primitive(0, 0)["extensions"][kExtension]["attributes"],
            (Json{{"NORMAL", 0}, {"TEXCOORD_0", 1}}));
  EXPECT_FALSE(small.primitive(0, 1)["extensions"][kExtension].contains("attributes"));
  EXPECT_EQ(small.primitive(0, 2)["extensions"][kExtension]["attributes"],
            (Json{{"NORMAL", 0}, {"COLOR_0", 2}}));
  expect_same_soups(OpenedGlb(builder.glb()), OpenedGlb(unpack_ok(packed.asset).asset));
}

TEST(GltfMeshStreams, BordersOfPrimitivesStayTogetherWhateverCodesThem) {
  const Bytes asset = with_ids(OpenedGlb(patchwork().glb()));
  const OpenedGlb before(asset);
  GltfPackOptions options;
  for (const GeometryCoder coder : {GeometryCoder::kHighpass, GeometryCoder::kPredictive}) {
    options.encode.geometry = coder;
    options.encode.bits = 6;
    const OpenedGlb after(unpack_ok(pack_ok(asset, options).asset).asset);
    expect_no_cracks(before, after);
  }
}

TEST(GltfMeshStreams, StreamsOfOneMeshThatTouchStayTogether) {
  GltfBuilder builder = patchwork();
  Json& second = builder.json["meshes"][0]["primitives"][1];
  second["extensions"]["X_names_vertices"] = {{"vertex", 7}};
  const Bytes asset = with_ids(OpenedGlb(builder.glb()));
  GltfPackOptions options;
  options.encode.bits = 6;
  const GltfOutput packed = pack_ok(asset, options);
  EXPECT_EQ(packed.report.streams, 2U);
  const OpenedGlb after(unpack_ok(packed.asset).asset);
  expect_no_cracks(OpenedGlb(asset), after);
  const auto ids = after.values<float>(after.primitive(0, 1)["attributes"]["_ID"]);
  for (std::size_t i = 0; i < ids.size(); ++i) EXPECT_EQ(ids[i], static_cast<float>(i));
}

TEST(GltfMeshStreams, BytesAreForAllStreamsTogether) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(20));
  builder.sheet_mesh(make_sheet(40));
  const std::uint64_t natural = pack_ok(builder.glb()).report.stream_bytes;
  GltfPackOptions options;
  options.encode.quality.target_bytes = natural * 2 / 3;
  const GltfReport report = pack_ok(builder.glb(), options).report;
  EXPECT_EQ(report.streams, 2U);
  EXPECT_LE(report.stream_bytes, natural * 2 / 3);
  EXPECT_GE(report.stream_bytes, natural / 2);
  for (const std::uint64_t bytes : {300, 1}) {
    options.encode.quality.target_bytes = bytes;
    const auto refused = pack_gltf(builder.glb(), options);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::kUnmetRequest);
  }
}

// Numbers that are kept exactly do not shrink with the others: their stream takes from the share of the
// other.
TEST(GltfMeshStreams, BytesAreSharedByWhatStreamsNeed) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(20));
  builder.sheet_mesh(make_sheet(60));
  std::mt19937 random(1);
  std::vector<float> noise(1200);
  for (float& number : noise) number = static_cast<float>(random() % 65536);
  builder.json["meshes"][0]["primitives"][0]["attributes"]["_NOISE"] = builder.floats(noise, 3);
  const GltfReport natural = pack_ok(builder.glb()).report;
  ASSERT_EQ(natural.stream_reports.size(), 2U);
  const std::uint64_t first = natural.stream_reports[0].info.bytes;
  const std::uint64_t second = natural.stream_reports[1].info.bytes;
  GltfPackOptions options;
  const std::uint64_t target = first * 95 / 100 + second * 3 / 4;
  options.encode.quality.target_bytes = target;
  const GltfReport report = pack_ok(builder.glb(), options).report;
  EXPECT_EQ(report.streams, 2U);
  EXPECT_LE(report.stream_bytes, target);
  options.encode.quality.target_bytes = 700;
  const auto refused = pack_gltf(builder.glb(), options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kUnmetRequest);
}

TEST(GltfMeshStreams, ASemanticOfTwoTypesIsTwoAttributes) {
  GltfBuilder builder = split_sheet();
  Json& attributes = builder.json["meshes"][0]["primitives"][1]["attributes"];
  attributes["TEXCOORD_0"] = builder.push(
      "accessors", {{"bufferView", builder.view(bytes_of(std::vector<std::uint16_t>(200, 777)), 34962)},
                    {"componentType", 5123},
                    {"normalized", true},
                    {"count", 100},
                    {"type", "VEC2"}});
  const GltfOutput packed = pack_ok(builder.glb(), lossless());
  EXPECT_EQ(packed.report.streams, 1U);
  expect_same_soups(OpenedGlb(builder.glb()), OpenedGlb(unpack_ok(packed.asset).asset));
}

TEST(GltfMeshStreams, EqualAttributesOfAPrimitiveAreCodedOnce) {
  GltfBuilder builder = split_sheet();
  Json& primitives = builder.json["meshes"][0]["primitives"];
  primitives[0]["attributes"]["TEXCOORD_1"] = builder.floats(make_sheet(10).uvs, 2);
  primitives[1]["attributes"]["TEXCOORD_1"] = builder.floats(std::vector<float>(200, 0.25F), 2);
  const GltfOutput packed = pack_ok(builder.glb(), lossless());
  const OpenedGlb small(packed.asset);
  const Json& first = small.primitive(0, 0);
  EXPECT_EQ(first["extensions"][kExtension]["attributes"],
            (Json{{"NORMAL", 0}, {"TEXCOORD_0", 1}, {"TEXCOORD_1", 1}}));
  EXPECT_EQ(first["attributes"]["TEXCOORD_0"], first["attributes"]["TEXCOORD_1"]);
  EXPECT_EQ(small.primitive(0, 1)["extensions"][kExtension]["attributes"],
            (Json{{"NORMAL", 0}, {"TEXCOORD_0", 1}, {"TEXCOORD_1", 2}}));
  expect_same_soups(OpenedGlb(builder.glb()), OpenedGlb(unpack_ok(packed.asset).asset));
}

TEST(GltfMeshStreams, EqualContentIsCodedOnce) {
  GltfBuilder builder = split_sheet();
  const std::size_t alone = pack_ok(builder.glb()).report.stream_bytes;
  add_split_sheet(builder);  // again, with accessors and bytes of its own
  const GltfOutput packed = pack_ok(builder.glb());
  EXPECT_EQ(packed.report.converted, 4U);
  EXPECT_EQ(packed.report.streams, 1U);
  EXPECT_EQ(packed.report.stream_bytes, alone);
  const OpenedGlb small(packed.asset);
  EXPECT_EQ(small.primitive(0, 0), small.primitive(1, 0));
  EXPECT_EQ(small.primitive(0, 1), small.primitive(1, 1));
  EXPECT_EQ(small.json["accessors"].size(), 5U);  // none is left unused
}

TEST(GltfMeshStreams, MeshesOfSharedAccessorsButOtherVerticesAreStreamsOfTheirOwn) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(10));
  Json second = builder.json["meshes"][0];
  builder.json["meshes"][0]["primitives"][0]["indices"] = builder.indices({0, 1, 10});
  second["primitives"][0]["indices"] = builder.indices({97, 98, 99});
  builder.push("meshes", second);
  EXPECT_EQ(pack_ok(builder.glb(), test::with_fallback()).report.streams, 2U);
  builder.json["meshes"][1]["primitives"][0]["indices"] = builder.indices({1, 98, 99});
  EXPECT_EQ(pack_ok(builder.glb(), test::with_fallback()).report.streams, 1U);
}

TEST(GltfMeshStreams, PercentagesCountInTheSmallestMeshOfAStream) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(20));
  Json corner = builder.json["meshes"][0];
  corner["primitives"][0]["indices"] = builder.indices({0, 1, 20});
  builder.push("meshes", corner);
  GltfPackOptions options;
  options.encode.quality.max_error = QualityBound{.value = 1, .unit = QualityUnit::kDiagonal};
  const GltfReport report = pack_ok(builder.glb(), options).report;
  EXPECT_EQ(report.streams, 1U);
  EXPECT_LE(report.max_error_percent, 1);
  EXPECT_LE(report.max_error, 0.01 * 2 / 19.0);  // the triangle's diagonal is about 1.4 / 19
}

TEST(GltfMeshStreams, ReportsBytesAndErrorsByAttribute) {
  GltfPackOptions options;
  options.encode.attributes.normal_error = 3;
  const GltfReport report = pack_ok(patchwork().glb(), options).report;
  ASSERT_EQ(report.stream_reports.size(), 1U);
  ASSERT_EQ(report.attributes.size(), 3U);
  EXPECT_EQ(report.attributes[0].semantic, "NORMAL");
  EXPECT_GT(report.attributes[0].error, 0);
  EXPECT_LE(report.attributes[0].error, 3);
  EXPECT_EQ(report.attributes[2].semantic, "COLOR_0");
  EXPECT_EQ(report.attributes[2].kind, AttributeKind::kColor);
  EXPECT_EQ(report.attributes[2].error, 0);
  std::uint64_t bytes = 0;
  for (const GltfAttributeReport& attribute : report.attributes) bytes += attribute.bytes;
  EXPECT_EQ(bytes, report.stream_reports[0].info.attribute_bytes);
}

}  // namespace
}  // namespace deltamesh
