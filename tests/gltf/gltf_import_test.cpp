// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// glTF as other programs write it: skinned nodes, instances, names with percent signs, bytes behind a GLB.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <string>

#include "deltamesh/io.h"
#include "support/gltf_asset.h"

namespace deltamesh::gltf_import_test {
namespace {

using test::Bytes;
using test::GltfBuilder;
using test::Json;
using test::make_sheet;

Result<Imported> read(const Bytes& file) { return read_mesh(file, FileFormat::kGlb); }

std::vector<float> positions_of(const GltfBuilder& builder) {
  const auto imported = read(builder.glb());
  EXPECT_TRUE(imported) << (imported ? "" : describe(imported.error()));
  if (!imported) return {};
  std::vector<float> positions = imported->mesh.positions;
  for (std::size_t i = 0; i < positions.size(); ++i)
    positions[i] = static_cast<float>(imported->mesh.origin[i % 3] + static_cast<double>(positions[i]));
  return positions;
}

TEST(GltfScene, TheNodeOfASkinnedMeshDoesNotMoveIt) {
  const test::Sheet sheet = make_sheet(3);
  GltfBuilder builder;
  builder.sheet_mesh(sheet);
  Json& node = builder.json["nodes"][0];
  node["translation"] = {100, 0, 0};
  EXPECT_EQ(positions_of(builder)[0], 100);
  node["skin"] = 0;
  builder.push("skins", {{"joints", {0}}});
  EXPECT_EQ(positions_of(builder), sheet.positions);
  node["scale"] = {2, -2, 2};  // a mirror image too
  EXPECT_EQ(positions_of(builder), sheet.positions);
  node = {{"mesh", 0}, {"skin", 0}, {"matrix", {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 5, 5, 1}}};
  EXPECT_EQ(positions_of(builder), sheet.positions);
  node = {{"children", {1}}, {"translation", {7, 7, 7}}};  // nor do the nodes above
  builder.push("nodes", {{"mesh", 0}, {"skin", 0}});
  builder.json["scenes"] = Json::array({Json{{"nodes", {0}}}});
  EXPECT_EQ(positions_of(builder), sheet.positions);
}

TEST(GltfScene, OneMeshAtSeveralNodesIsPlacedAtEach) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(3));
  builder.push("nodes", {{"mesh", 0}, {"translation", {10, 0, 0}}});
  builder.push("nodes", {{"mesh", 0}, {"scale", {3, 3, 3}}});
  const auto positions = positions_of(builder);
  ASSERT_EQ(positions.size(), 81U);
  EXPECT_EQ(positions[27], 10);
  EXPECT_EQ(positions[78], 3);
}

/// A sheet with three instances.
GltfBuilder instanced() {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(3));
  const std::size_t translation = builder.floats({0, 0, 0, 10, 0, 0, 20, 0, 0}, 3);
  builder.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] =
      translation;
  builder.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  return builder;
}

Json& instances_of(GltfBuilder& builder) {
  return builder.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
}

TEST(GltfScene, InstancesArePlacedOneByOne) {
  GltfBuilder builder = instanced();
  builder.json["nodes"][0]["translation"] = {0, 5, 0};
  const std::vector<float> moved = positions_of(builder);
  ASSERT_EQ(moved.size(), 81U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(moved[27 * i], 10 * static_cast<float>(i));
    EXPECT_EQ(moved[27 * i + 1], 5);
  }
  instances_of(builder)["SCALE"] = builder.floats({1, 1, 1, 2, 2, 2, 3, 3, 3}, 3);
  const std::vector<float> scaled = positions_of(builder);
  ASSERT_EQ(scaled.size(), 81U);
  EXPECT_EQ(scaled[27 + 24], 12);      // the corner at (1, 1), twice as far
  EXPECT_EQ(scaled[2 * 27 + 24], 23);  // three times
  // A quarter turn about z in normalized 16-bit integers, as exporters quantise rotations.
  const auto half = static_cast<std::int16_t>(23170);
  const std::size_t view = builder.view(
      test::bytes_of(std::vector<std::int16_t>{0, 0, 0, 32767, 0, 0, half, half, 0, 0, 0, 32767}));
  instances_of(builder)["ROTATION"] = builder.push(
      "accessors",
      {{"bufferView", view}, {"componentType", 5122}, {"normalized", true}, {"count", 3}, {"type", "VEC4"}});
  const std::vector<float> turned = positions_of(builder);
  ASSERT_EQ(turned.size(), 81U);
  EXPECT_NEAR(turned[27 + 6], 10, 1e-3F);  // (1, 0) is at (0, 2) now
  EXPECT_NEAR(turned[27 + 7], 7, 1e-3F);
}

TEST(GltfScene, InstancesThatCannotBeReadAreErrors) {
  GltfBuilder counts = instanced();
  instances_of(counts)["SCALE"] = counts.floats({1, 1, 1}, 3);
  EXPECT_FALSE(read(counts.glb()));
  GltfBuilder shape = instanced();
  instances_of(shape)["ROTATION"] = instances_of(shape)["TRANSLATION"];
  EXPECT_FALSE(read(shape.glb()));
  GltfBuilder none = instanced();
  instances_of(none)["TRANSLATION"] = 99;
  EXPECT_FALSE(read(none.glb()));
  GltfBuilder hollow = instanced();  // few bytes that stand for many instances
  instances_of(hollow)["TRANSLATION"] =
      hollow.push("accessors", {{"componentType", 5126}, {"count", 1000000000}, {"type", "VEC3"}});
  EXPECT_FALSE(read(hollow.glb()));
  GltfBuilder repeated = instanced();
  instances_of(repeated)["TRANSLATION"] = repeated.floats(std::vector<float>(3000), 3);
  for (int i = 0; i < 200; ++i) repeated.json["nodes"].push_back(repeated.json["nodes"][0]);
  EXPECT_FALSE(read(repeated.glb()));
}

TEST(GltfFileNames, PercentSignsThatBeginNoEscapeStandForThemselves) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "deltamesh_percent";
  std::filesystem::create_directories(folder);
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(3));
  constexpr std::array<std::pair<const char*, const char*>, 4> kNames{{{"example 10%.bin", "example 10%.bin"},
                                                                       {"100%", "100%"},
                                                                       {"a%2g.bin", "a%2g.bin"},
                                                                       {"5%25.bin", "5%.bin"}}};
  for (const auto& [uri, name] : kNames) {
    ASSERT_TRUE(write_file((folder / name).string(), builder.bin));
    const auto imported = read_mesh(builder.gltf(uri), FileFormat::kGltf, folder.string());
    EXPECT_TRUE(imported) << uri;
  }
  for (const char* uri : {"../x.bin", "a/../../x%.bin", "%2e%2e/x.bin", "/etc/10%", "file:///x%.bin"}) {
    const auto refused = read_mesh(builder.gltf(uri), FileFormat::kGltf, folder.string());
    ASSERT_FALSE(refused) << uri;
    EXPECT_NE(std::string(refused.error().message).find("unsafe"), std::string::npos)
        << refused.error().message;
  }
  std::filesystem::remove_all(folder);
}

TEST(GlbReader, BytesBehindTheEndAreLeftAlone) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(3));
  const Bytes glb = builder.glb();
  const auto plain = read(glb);
  ASSERT_TRUE(plain);
  for (const std::size_t more : {std::size_t{1}, std::size_t{7}, glb.size()}) {  // at last another GLB
    Bytes longer = glb;
    longer.insert(longer.end(), glb.begin(), glb.begin() + static_cast<std::ptrdiff_t>(more));
    const auto imported = read(longer);
    ASSERT_TRUE(imported) << more;
    EXPECT_EQ(imported->mesh.positions, plain->mesh.positions);
  }
}

}  // namespace
}  // namespace deltamesh::gltf_import_test
