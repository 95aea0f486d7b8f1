// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// glTF: scenes, accessors of all kinds, buffers elsewhere, and hostile descriptions.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>

#include "base/byte_writer.h"
#include "io/gltf/uri.h"
#include "io_support.h"

namespace deltamesh {
namespace {

using test::expect_error;
using test::expect_robust;
using test::expect_valid;
using test::find;
using test::left_out;
using test::numbers;
using test::read_exact;
using test::read_text;

constexpr FileFormat kGltf = FileFormat::kGltf;

/// A square in the plane z = 0: 4 positions, then 6 indices of 16 bits, then 4 colours of 4 bytes.
std::vector<std::byte> square() {
  ByteWriter out;
  for (const float value : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 1.F, 1.F, 0.F, 0.F, 1.F, 0.F}) out.write(value);
  for (const int index : {0, 1, 2, 0, 2, 3}) out.write(static_cast<std::uint16_t>(index));
  for (int i = 0; i < 16; ++i) out.write(static_cast<std::uint8_t>(i * 16));
  return out.take();
}

constexpr const char* kViews = R"("bufferViews":[{"buffer":0,"byteLength":48},
  {"buffer":0,"byteOffset":48,"byteLength":12},{"buffer":0,"byteOffset":60,"byteLength":16}],)";
constexpr const char* kAccessors = R"("accessors":[
  {"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
  {"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"},
  {"bufferView":2,"componentType":5121,"count":4,"type":"VEC4","normalized":true}],)";

/// A description over square(): what differs from test to test, and the members above unless replaced.
std::string asset(const std::string& members, const std::string& accessors = kAccessors,
                  const std::string& views = kViews) {
  const auto bytes = square();
  return R"({"asset":{"version":"2.0"},)" + views + accessors + members + R"(,"buffers":[{"byteLength":)" +
         std::to_string(bytes.size()) + R"(,"uri":")" + gltf::data_uri_of(bytes) + "\"}]}";
}

constexpr const char* kMesh =
    R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"COLOR_0":2},"indices":1}]}])";

std::string nodes(const std::string& text) { return std::string(kMesh) + ",\"nodes\":" + text; }

Mesh read(const std::string& text) {
  auto imported = read_text(text, kGltf);
  EXPECT_TRUE(imported) << describe(imported.error());
  if (!imported) return {};
  expect_valid(imported->mesh);
  return std::move(imported->mesh);
}

TEST(GltfReader, MeshesWithoutNodes) {
  const Mesh mesh = read(asset(kMesh));
  EXPECT_EQ(mesh.positions, (std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}));
  EXPECT_EQ(mesh.triangles, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  ASSERT_EQ(mesh.attributes.size(), 1U);
  EXPECT_EQ(mesh.attributes[0].name, "COLOR_0");
  EXPECT_EQ(mesh.attributes[0].kind, AttributeKind::kColor);
  EXPECT_EQ(numbers<std::uint8_t>(mesh.attributes[0])[15], 240);
  expect_robust(test::bytes_of(asset(kMesh)), kGltf);
}

TEST(GltfReader, NodesMoveTurnAndRepeatMeshes) {
  // A quarter turn about z and a scale of 2 in the parent, instances with a shift and with a mirror image.
  const Mesh mesh = read(asset(nodes(R"([{"children":[1,2],"translation":[10,0,0],
      "rotation":[0,0,0.7071067811865476,0.7071067811865476],"scale":[2,2,2]},
      {"mesh":0,"translation":[1,0,0]},{"mesh":0,"matrix":[-1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}])")));
  ASSERT_EQ(mesh.vertex_count(), 8U);
  // (x, y) -> (10 - 2y, 2(x + 1)) and (10 - 2y, -2x)
  const std::vector<float> expected{10, 2, 0, 10, 4,  0, 8, 4,  0, 8, 2, 0,
                                    10, 0, 0, 10, -2, 0, 8, -2, 0, 8, 0, 0};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(mesh.positions[i], expected[i], 1e-6F) << i;
  EXPECT_EQ(mesh.triangles, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6}));
}

TEST(GltfReader, OnlyTheDefaultSceneIsRead) {
  const std::string two =
      nodes(R"([{"mesh":0},{"mesh":0},{"mesh":0}],"scenes":[{"nodes":[0]},{"nodes":[1,0]}])");
  EXPECT_EQ(read(asset(two + ",\"scene\":0")).vertex_count(), 4U);
  EXPECT_EQ(read(asset(two + ",\"scene\":1")).vertex_count(), 8U);
  EXPECT_EQ(read(asset(two)).vertex_count(), 8U);  // all scenes, the node they share once
  EXPECT_EQ(read(asset(nodes(R"([{"mesh":0,"children":[1]},{"mesh":0}])"))).vertex_count(), 8U);
  expect_error(asset(two + ",\"scene\":2"), kGltf);
  expect_error(asset(two + ",\"scene\":-2"), kGltf);
}

TEST(GltfReader, BrokenNodeTreesAreErrors) {
  for (const char* text :
       {R"([{"mesh":0,"children":[0]}],"scenes":[{"nodes":[0]}])", R"([{"children":[1,1]},{"mesh":0}])",
        R"([{"children":[7]}])", R"([{"mesh":1}])", R"([{"mesh":-5}])", R"([{"mesh":0,"matrix":[1,2,3]}])",
        R"([{"mesh":0,"scale":[1,2]}])", R"([{"mesh":0}],"scenes":[{"nodes":[3]}])",
        R"([{"children":[[[[1]]]]}])", R"({})", R"([17])"})
    expect_error(asset(nodes(text)), kGltf);
}

TEST(GltfReader, DeepNodeTreesDoNotExhaustTheStack) {
  std::string chain = "[";
  for (int i = 1; i <= 50000; ++i) chain += R"({"children":[)" + std::to_string(i) + "]},";
  const Mesh mesh = read(asset(nodes(chain + R"({"mesh":0}])")));
  EXPECT_EQ(mesh.vertex_count(), 4U);
}

TEST(GltfReader, DeepJsonDoesNotExhaustTheStack) {
  const std::string open(200000, '[');
  const std::string close(200000, ']');
  const auto deep = read_text(asset(std::string(kMesh) + ",\"extras\":" + open + close), kGltf);
  ASSERT_FALSE(deep);
  EXPECT_EQ(deep.error().code, ErrorCode::kLimitExceeded);
  expect_error(open, kGltf);
}

TEST(GltfReader, StripsFansAndOtherPrimitives) {
  const auto with_mode = [](const std::string& mode) {
    return asset(R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":)" + mode +
                 R"(},{"attributes":{"POSITION":0},"mode":1},{"attributes":{"COLOR_0":2}}]}])");
  };
  EXPECT_EQ(read(with_mode("5")).triangles, (std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2}));
  EXPECT_EQ(read(with_mode("6")).triangles, (std::vector<std::uint32_t>{1, 2, 0, 2, 3, 0}));
  const auto imported = read_text(with_mode("4"), kGltf);
  ASSERT_TRUE(imported);
  EXPECT_EQ(imported->mesh.triangles, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(left_out(imported->report, LeftOutKind::kPrimitives), 2U);
  EXPECT_EQ(left_out(imported->report, LeftOutKind::kFaces), 1U);
}

TEST(GltfReader, PrimitivesOfOneMeshShareTheirVertices) {
  const Mesh mesh = read(asset(R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1},
      {"attributes":{"POSITION":0},"mode":5},{"attributes":{"POSITION":0,"COLOR_0":2},"mode":5}]}])"));
  EXPECT_EQ(mesh.vertex_count(), 8U);
  EXPECT_EQ(mesh.triangle_count(), 6U);
  // The primitive without colours is white.
  const auto colors = numbers<std::uint8_t>(*find(mesh, AttributeKind::kColor));
  EXPECT_EQ(colors[0], 255);
  EXPECT_EQ(colors[16], 0);
  EXPECT_EQ(colors[31], 240);
}

TEST(GltfReader, AttributesThatNotAllHaveAreDropped) {
  const std::string accessors = R"("accessors":[
    {"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
    {"bufferView":2,"componentType":5121,"count":4,"type":"VEC4"},
    {"bufferView":2,"componentType":5123,"count":4,"type":"VEC2","normalized":true},
    {"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"}],)";
  const Mesh mesh = read(asset(R"("meshes":[{"primitives":[
    {"attributes":{"POSITION":0,"_A":1,"NORMAL":3,"TEXCOORD_0":2,"_B":1},"mode":5},
    {"attributes":{"POSITION":0,"_A":1},"mode":5}]}])",
                               accessors));
  ASSERT_EQ(mesh.attributes.size(), 3U);
  EXPECT_EQ(mesh.attributes[0].name, "NORMAL");
  EXPECT_EQ(mesh.attributes[1].name, "TEXCOORD_0");
  EXPECT_EQ(mesh.attributes[1].type, ComponentType::kF32);
  const auto uv = numbers<float>(mesh.attributes[1]);
  EXPECT_FLOAT_EQ(uv[0], 0x1000 / 65535.0F);
  EXPECT_EQ(uv[8], 0);
  EXPECT_EQ(mesh.attributes[2].name, "_A");
  EXPECT_EQ(mesh.attributes[2].kind, AttributeKind::kGeneric);
  EXPECT_FALSE(mesh.attributes[2].normalized);
}

TEST(GltfReader, MissingNormalsComeFromTheFaces) {
  const Mesh mesh = read(asset(R"("meshes":[{"primitives":[
    {"attributes":{"POSITION":0,"NORMAL":0},"indices":1},{"attributes":{"POSITION":0},"indices":1}]}])"));
  ASSERT_EQ(mesh.attributes.size(), 1U);
  EXPECT_EQ(mesh.attributes[0].kind, AttributeKind::kNormal);
  const auto normals = numbers<float>(mesh.attributes[0]);
  ASSERT_EQ(normals.size(), 24U);
  for (std::size_t v = 4; v < 8; ++v) {
    EXPECT_EQ(normals[3 * v], 0);
    EXPECT_EQ(normals[3 * v + 1], 0);
    EXPECT_EQ(std::abs(normals[3 * v + 2]), 1);
  }
}

TEST(GltfReader, SkinsAndTangentsKeepTheirKindsAndNames) {
  ByteWriter out;
  for (const float value : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) out.write(value);  // 0
  for (int v = 0; v < 3; ++v)
    for (const float value : {0.F, 0.F, 1.F}) out.write(value);  // 36
  for (int v = 0; v < 3; ++v)
    for (const float value : {0.F, 1.F, 0.F, v == 1 ? -1.F : 1.F}) out.write(value);  // 72
  for (const int joint : {3, 2, 1, 0, 7, 0, 0, 0, 9, 8, 0, 0})
    out.write(static_cast<std::uint8_t>(joint));  // 120
  for (const int weight : {255, 0, 0, 0, 128, 127, 0, 0, 85, 85, 85, 0})
    out.write(static_cast<std::uint8_t>(weight));  // 132
  const std::string text = R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[
    {"attributes":{"POSITION":0,"NORMAL":1,"TANGENT":2,"JOINTS_0":3,"WEIGHTS_0":4}}]}],"bufferViews":[
      {"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":36},
      {"buffer":0,"byteOffset":72,"byteLength":48},{"buffer":0,"byteOffset":120,"byteLength":12},
      {"buffer":0,"byteOffset":132,"byteLength":12}],"accessors":[
      {"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
      {"bufferView":1,"componentType":5126,"count":3,"type":"VEC3"},
      {"bufferView":2,"componentType":5126,"count":3,"type":"VEC4"},
      {"bufferView":3,"componentType":5121,"count":3,"type":"VEC4"},
      {"bufferView":4,"componentType":5121,"normalized":true,"count":3,"type":"VEC4"}],
    "buffers":[{"byteLength":144,"uri":")" +
                           gltf::data_uri_of(out.bytes()) + "\"}]}";
  const Mesh mesh = read(text);
  ASSERT_EQ(mesh.attributes.size(), 4U);
  EXPECT_EQ(mesh.attributes[0].kind, AttributeKind::kJoints);
  EXPECT_EQ(mesh.attributes[2].kind, AttributeKind::kTangent);
  EXPECT_EQ(mesh.attributes[3].kind, AttributeKind::kWeights);
  EXPECT_TRUE(mesh.attributes[3].normalized);
  const auto written = write_mesh(mesh, FileFormat::kGlb);
  ASSERT_TRUE(written);
  const auto again = read_mesh(*written, FileFormat::kGlb);
  ASSERT_TRUE(again) << describe(again.error());
  ASSERT_EQ(again->mesh.attributes.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(again->mesh.attributes[i].name, mesh.attributes[i].name);
    EXPECT_EQ(again->mesh.attributes[i].kind, mesh.attributes[i].kind);
    EXPECT_EQ(again->mesh.attributes[i].type, mesh.attributes[i].type);
    EXPECT_EQ(again->mesh.attributes[i].values, mesh.attributes[i].values);
  }
}

TEST(GltfReader, NormalsTurnByTheInverseTranspose) {
  ByteWriter out;
  for (int v = 0; v < 3; ++v)
    for (const float value : {0.F, static_cast<float>(v == 1), static_cast<float>(v == 2), 0.6F, 0.8F, 0.F})
      out.write(value);
  const std::string text = R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0,"scale":[-2,1,1]}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1}}]}],
    "bufferViews":[{"buffer":0,"byteLength":72,"byteStride":24}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
      {"bufferView":0,"byteOffset":12,"componentType":5126,"count":3,"type":"VEC3"}],
    "buffers":[{"byteLength":72,"uri":")" +
                           gltf::data_uri_of(out.bytes()) + "\"}]}";
  const Mesh mesh = read(text);
  EXPECT_EQ(mesh.triangles, (std::vector<std::uint32_t>{0, 2, 1}));
  const auto normals = numbers<float>(*find(mesh, AttributeKind::kNormal));
  const float length = std::sqrt(0.09F + 0.64F);
  EXPECT_NEAR(normals[0], -0.3F / length, 1e-6F);
  EXPECT_NEAR(normals[1], 0.8F / length, 1e-6F);
}

TEST(GltfReader, SparseAccessors) {
  // The values of accessor 0 with vertex 2 replaced by the first three floats of the positions; then zeros
  // with the same.
  const std::string sparse =
      R"("sparse":{"count":1,"indices":{"bufferView":1,"byteOffset":4,"componentType":5123},
      "values":{"bufferView":0,"byteOffset":12}}},)";
  const std::string accessors =
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3",)" + sparse +
      R"({"componentType":5126,"count":4,"type":"VEC3",)" + sparse +
      R"({"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}],)";
  const auto mesh_of = [&](const std::string& position) {
    return R"("meshes":[{"primitives":[{"attributes":{"POSITION":)" + position + R"(},"indices":2}]}])";
  };
  EXPECT_EQ(read(asset(mesh_of("0"), accessors)).positions,
            (std::vector<float>{0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0}));
  EXPECT_EQ(read(asset(mesh_of("1"), accessors)).positions,
            (std::vector<float>{0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0}));
}

TEST(GltfReader, AccessorsOutsideTheirBytesAreErrors) {
  const std::string mesh = R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":5}]}])";
  for (
      const char* accessor :
      {R"({"bufferView":0,"componentType":5126,"count":5,"type":"VEC3"})",
       R"({"bufferView":0,"byteOffset":4,"componentType":5126,"count":4,"type":"VEC3"})",
       R"({"bufferView":0,"byteOffset":18446744073709551615,"componentType":5126,"count":4,"type":"VEC3"})",
       R"({"bufferView":0,"componentType":5126,"count":1537228672809129302,"type":"VEC3"})",
       R"({"componentType":5126,"count":4000000000,"type":"VEC3"})",
       R"({"bufferView":9,"componentType":5126,"count":4,"type":"VEC3"})",
       R"({"bufferView":-7,"componentType":5126,"count":4,"type":"VEC3"})",
       R"({"bufferView":0,"componentType":5125,"count":4,"type":"VEC2"})",
       R"({"bufferView":0,"componentType":5127,"count":4,"type":"VEC3"})",
       R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC9"})",
       R"({"bufferView":0,"componentType":5126,"count":-4,"type":"VEC3"})",
       R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":1}})",
       R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":1,"indices":{"bufferView":1,
           "byteOffset":11,"componentType":5123},"values":{"bufferView":0}}})",
       R"({"bufferView":0,"componentType":5126,"count":2,"type":"VEC3","sparse":{"count":1,"indices":{"bufferView":1,
           "byteOffset":4,"componentType":5123},"values":{"bufferView":0}}})",
       R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":-1,"indices":{"bufferView":1,
           "byteOffset":4,"componentType":5123},"values":{"bufferView":0}}})"})
    expect_error(asset(mesh, std::string(R"("accessors":[)") + accessor + "],"), kGltf);
  for (const char* view :
       {R"({"buffer":1,"byteLength":48})", R"({"buffer":-1,"byteLength":48})",
        R"({"buffer":0,"byteLength":480})", R"({"buffer":0,"byteOffset":70,"byteLength":48})",
        R"({"buffer":0,"byteOffset":18446744073709551615,"byteLength":48})",
        R"({"buffer":0,"byteLength":48,"byteStride":4})", R"({"buffer":0})"})
    expect_error(
        asset(mesh, R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"}],)",
              std::string(R"("bufferViews":[)") + view + "],"),
        kGltf);
}

TEST(GltfReader, IndicesOutsideTheirVerticesAreErrors) {
  const auto indexed = [](const std::string& accessor) {
    return asset(
        R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}])",
        R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},)" + accessor + "],");
  };
  expect_error(indexed(R"({"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"})"), kGltf);
  expect_error(indexed(R"({"bufferView":1,"componentType":5122,"count":3,"type":"SCALAR"})"), kGltf);
  expect_error(indexed(R"({"bufferView":1,"componentType":5123,"count":3,"type":"VEC2"})"), kGltf);
  EXPECT_EQ(
      read(indexed(R"({"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"})")).triangle_count(),
      1U);
}

TEST(GltfReader, RepeatedInstancesCannotGrowWithoutBound) {
  // Without data an accessor costs nothing; a million instances of it would be terabytes.
  std::string instances;
  for (int i = 0; i < 200; ++i) instances += R"({"mesh":0},)";
  const auto placed = [&](const char* count) {
    return R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
    "accessors":[{"componentType":5126,"count":)" +
           std::string(count) + R"(,"type":"VEC3"}],"nodes":[)" + instances + R"({"mesh":0}]})";
  };
  expect_error(placed("30000"), kGltf);
  // A small tree, two hundred times, is a forest.
  EXPECT_EQ(read(placed("800")).vertex_count(), 201U * 800);
}

TEST(GltfReader, ExtensionsThatHideTheGeometryAreErrors) {
  for (const char* name : {"DELTAMESH_mesh_compression", "KHR_draco_mesh_compression",
                           "EXT_meshopt_compression", "EXT_some_instancing"})
    expect_error(asset(std::string(kMesh) + R"(,"extensionsRequired":[")" + name + "\"]"), kGltf);
  read(
      asset(std::string(kMesh) + R"(,"extensionsRequired":["KHR_materials_unlit","KHR_mesh_quantization"])"));
}

TEST(GltfReader, ImagesAndMaterialsAreLeftAlone) {
  const Mesh plain = read(asset(kMesh));
  const Mesh mesh =
      read(asset(std::string(kMesh) +
                 R"(,"images":[{"uri":"../../etc/passwd"},{"bufferView":99}],"textures":[{"source":5}],
      "materials":[{"pbrMetallicRoughness":7}],"animations":"none","skins":[{"joints":[99]}])"));
  EXPECT_EQ(mesh.positions, plain.positions);
  EXPECT_EQ(mesh.triangles, plain.triangles);
}

TEST(GltfReader, CountsAttributesThatItLeavesOut) {
  const std::string long_name = "_" + std::string(255, 'n');
  const auto imported =
      read_text(asset(R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"_ONE":0,")" + long_name +
                      R"(":0},"indices":1},{"attributes":{"POSITION":0},"indices":1}]}])"),
                kGltf);
  ASSERT_TRUE(imported) << describe(imported.error());
  EXPECT_TRUE(imported->mesh.attributes.empty());
  EXPECT_EQ(imported->report.left_out.size(), 2U);
}

TEST(GltfReader, BuffersInOtherFiles) {
  const auto folder = std::filesystem::path(::testing::TempDir()) / "deltamesh gltf";
  std::filesystem::create_directories(folder);
  const auto bytes = square();
  std::ofstream(folder / "a b.bin", std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  const auto with_uri = [&](const std::string& uri) {
    return std::string(R"({"asset":{"version":"2.0"},)") + kViews + kAccessors + kMesh +
           R"(,"buffers":[{"byteLength":76,"uri":")" + uri + "\"}]}";
  };
  const auto read_from = [](const std::string& text, const std::string& where) {
    return read_mesh(std::as_bytes(std::span(text)), kGltf, where);
  };
  EXPECT_TRUE(read_from(with_uri("a%20b.bin"), folder.string()));
  EXPECT_TRUE(read_from(with_uri("./a b.bin"), folder.string()));
  EXPECT_FALSE(read_from(with_uri("a%20b.bin"), ""));
  const auto missing = read_from(with_uri("c.bin"), folder.string());
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::kFileOpen);
  for (const char* uri : {"../deltamesh gltf/a b.bin", "/etc/passwd", "file:///etc/passwd", "x/../../a",
                          "%2e%2e/a", "%2Fetc/passwd", "a%00b", "..\\\\a", ""}) {
    const auto refused = read_from(with_uri(uri), folder.string());
    ASSERT_FALSE(refused) << uri;
    EXPECT_EQ(refused.error().code, ErrorCode::kInvalidFile) << uri;
  }
  std::filesystem::remove_all(folder);
}

TEST(GltfReader, DataUris) {
  EXPECT_EQ(test::text_of(*gltf::decode_data_uri("data:text/plain;base64,aGVsbG8=")), "hello");
  EXPECT_EQ(test::text_of(*gltf::decode_data_uri("data:;base64,aGVsbG8h")), "hello!");
  EXPECT_EQ(test::text_of(*gltf::decode_data_uri("data:;base64,aGVsbG8%3D")), "hello");
  EXPECT_EQ(*gltf::decode_data_uri("data:;base64,%2b%2F%2B%2f"), *gltf::decode_data_uri("data:;base64,+/+/"));
  for (const char* uri :
       {"data:,hello", "data:;base64,a*b", "data:;base64,aGVs%", "data:;base64,aGVs%2", "base64,aGVs", ""})
    EXPECT_FALSE(gltf::decode_data_uri(uri)) << uri;
}

TEST(GlbReader, BrokenContainersAreErrors) {
  const auto bytes = *write_mesh(test::small_mesh(), FileFormat::kGlb);
  const auto changed = [&](std::size_t at, int value) {
    auto copy = bytes;
    copy[at] = static_cast<std::byte>(value);
    return read_exact(copy, FileFormat::kGlb);
  };
  EXPECT_TRUE(read_exact(bytes, FileFormat::kGltf));  // told apart by content
  EXPECT_FALSE(changed(0, 'G'));
  const auto version = changed(4, 1);
  ASSERT_FALSE(version);
  EXPECT_EQ(version.error().where, 4U);
  const auto length = changed(11, 0x7f);
  ASSERT_FALSE(length);
  EXPECT_EQ(length.error().where, 8U);
  EXPECT_FALSE(changed(15, 0xff));
  EXPECT_FALSE(changed(16, 'B'));
}

TEST(GltfReader, NotGltfAtAll) {
  for (const char* text :
       {"", "x", "null", "[]", "17", "{}", R"({"asset":1})", R"({"asset":{"version":2}})",
        R"({"asset":{"version":"2.0"},"meshes":7})", R"({"asset":{"version":"2.0"},"meshes":[7]})",
        R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{}]}]})",
        R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":1e999}}]}]})",
        "\xff\xfe{}"})
    expect_error(text, kGltf);
  EXPECT_EQ(read(R"({"asset":{"version":"2.0"}})").vertex_count(), 0U);
}

}  // namespace
}  // namespace deltamesh
