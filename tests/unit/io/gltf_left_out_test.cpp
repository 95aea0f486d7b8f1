// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Nothing of a glTF asset is lost or made up in silence.
#include <gtest/gtest.h>

#include <string>

#include "io_support.h"
#include "support/gltf_asset.h"

namespace deltamesh::gltf_left_out_test {
namespace {

using test::GltfBuilder;
using test::Json;
using test::left_out;
using test::make_sheet;

Imported read(const GltfBuilder& builder) {
  auto imported = read_mesh(builder.glb(), FileFormat::kGlb);
  EXPECT_TRUE(imported) << (imported ? "" : describe(imported.error()));
  return imported ? *std::move(imported) : Imported{};
}

TEST(GltfLeftOut, ValuesOfVerticesWithoutAreGuesses) {
  const test::Sheet sheet = make_sheet(3);
  GltfBuilder builder;
  builder.sheet_mesh(sheet);
  EXPECT_TRUE(read(builder).report.left_out.empty());
  Json bare = builder.json["meshes"][0];
  Json& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["COLOR_0"] = builder.floats(std::vector<float>(27, 0.5F), 3);
  for (const char* const name : {"TANGENT", "WEIGHTS_0"})
    attributes[name] = builder.floats(std::vector<float>(36, 0.25F), 4);
  bare["primitives"][0]["attributes"] = {{"POSITION", attributes["POSITION"]}};
  builder.push("nodes", {{"mesh", builder.push("meshes", bare)}});
  const ReadReport report = read(builder).report;
  for (const char* const guess : {"white as COLOR_0", "normals of the faces around as NORMAL",
                                  "1 0 0 1 as TANGENT", "0 as TEXCOORD_0", "0 as WEIGHTS_0"})
    EXPECT_EQ(left_out(report, LeftOutKind::kGuesses, std::string(guess) + " of vertices without"), 9U)
        << guess;
  EXPECT_EQ(report.left_out.size(), 5U);
}

TEST(GltfLeftOut, MeshesThatTheSceneDoesNotShow) {
  constexpr const char* kHidden = "meshes that the scene does not show";
  GltfBuilder builder;
  const test::Sheet sheet = make_sheet(3);
  for (int i = 0; i < 3; ++i) builder.sheet_mesh(sheet);
  EXPECT_EQ(left_out(read(builder).report, LeftOutKind::kPrimitives, kHidden), 0U);
  builder.json["scenes"] = Json::array({Json{{"nodes", {1}}}, Json{{"nodes", {1, 2}}}});
  EXPECT_EQ(left_out(read(builder).report, LeftOutKind::kPrimitives, kHidden), 1U);
  builder.json["scene"] = 0;
  EXPECT_EQ(left_out(read(builder).report, LeftOutKind::kPrimitives, kHidden), 2U);
  builder.json["scenes"][0].erase("nodes");
  EXPECT_EQ(left_out(read(builder).report, LeftOutKind::kPrimitives, kHidden), 3U);
  builder.json["meshes"].push_back(builder.json["meshes"][0]);  // which no node names
  builder.push("nodes", {{"mesh", 0}});                         // another place of one
  EXPECT_EQ(left_out(read(builder).report, LeftOutKind::kPrimitives, kHidden), 5U);
}

TEST(GltfLeftOut, ExtensionsThatMaySaySomethingAboutMeshes) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(3));
  builder.json["extensionsUsed"] = {
      "KHR_materials_unlit", "KHR_texture_transform", "KHR_mesh_quantization",  "EXT_mesh_gpu_instancing",
      "KHR_lights_punctual", "EXT_mesh_features",     "KHR_materials_variants", "KHR_node_visibility"};
  const ReadReport report = read(builder).report;
  for (const char* const name : {"EXT_mesh_features", "KHR_materials_variants", "KHR_node_visibility"})
    EXPECT_EQ(left_out(report, LeftOutKind::kElements, std::string("extension ") + name), 1U) << name;
  EXPECT_EQ(report.left_out.size(), 3U);
}

}  // namespace
}  // namespace deltamesh::gltf_left_out_test
