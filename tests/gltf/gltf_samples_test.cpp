// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The sample assets of the extension: valid ones unpack to a cube, each invalid one breaks the rule that its
// name begins with. `gltf_samples_test --update_samples` rewrites them: only on purpose, with a new draft
// number.
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <functional>
#include <string>

#include "deltamesh/gltf.h"
#include "deltamesh/io.h"
#include "gltf_packing.h"
#include "sample_assets.h"

namespace deltamesh {
namespace {

using test::Bytes;
using test::bytes_of;
using test::Json;
using test::kExtension;
using test::OpenedGlb;

bool update_samples = false;
const std::filesystem::path kFolder = DELTAMESH_SOURCE_DIR "/gltf_ext/DELTAMESH_mesh_compression/samples";

struct InvalidSample {
  const char* name;
  const char* rule;
  std::function<void(Json& asset, Json& primitive)> spoil;
};

const std::vector<InvalidSample>& invalid_samples() {
  static const std::vector<InvalidSample> samples{
      {"GLTF-1_view_missing", "GLTF-1",
       [](Json&, Json& p) { p["extensions"][kExtension].erase("bufferView"); }},
      {"GLTF-2_points", "GLTF-2", [](Json&, Json& p) { p["mode"] = 0; }},
      {"GLTF-3_no_indices", "GLTF-3", [](Json&, Json& p) { p.erase("indices"); }},
      {"GLTF-4_position_listed", "GLTF-4",
       [](Json&, Json& p) { p["extensions"][kExtension]["attributes"]["POSITION"] = 0; }},
      {"GLTF-4_number_too_large", "GLTF-4",
       [](Json&, Json& p) { p["extensions"][kExtension]["attributes"]["NORMAL"] = 2; }},
      {"GLTF-4_target_missing", "GLTF-4",
       [](Json&, Json& p) {
         p["extensions"][kExtension]["targets"] = Json::array({Json{{"NORMAL", 0}}});
       }},
      {"GLTF-5_count_differs", "GLTF-5", [](Json& a, Json&) { a["accessors"][0]["count"] = 23; }},
      {"GLTF-6_accessor_twice", "GLTF-6",
       [](Json&, Json& p) { p["attributes"]["NORMAL"] = p["attributes"]["POSITION"]; }},
      {"GLTF-11_no_such_group", "GLTF-11", [](Json&, Json& p) { p["extensions"][kExtension]["group"] = 1; }},
  };
  return samples;
}

Bytes packed_asset(const test::GltfBuilder& asset, bool fallback, GltfContainer container) {
  GltfPackOptions options;
  options.fallback = fallback;
  GltfIo io;
  io.container = container;
  const auto packed = pack_gltf(asset.glb(), options, io);
  EXPECT_TRUE(packed);
  return packed ? packed->asset : Bytes{};
}

Bytes packed_cube(bool fallback, GltfContainer container) {
  return packed_asset(test::cube_asset(), fallback, container);
}

void rewrite_samples() {
  const auto put = [](const std::string& name, const Bytes& bytes) {
    ASSERT_TRUE(write_file((kFolder / name).string(), bytes));
  };
  std::filesystem::create_directories(kFolder / "valid");
  std::filesystem::create_directories(kFolder / "invalid");
  put("valid/cube.glb", packed_cube(false, GltfContainer::kGlb));
  put("valid/cube.gltf", packed_cube(false, GltfContainer::kGltf));
  put("valid/cube_fallback.glb", packed_cube(true, GltfContainer::kGlb));
  put("valid/two_materials.gltf", packed_asset(test::two_material_cube_asset(), false, GltfContainer::kGltf));
  const Bytes text = packed_cube(false, GltfContainer::kGltf);
  const auto* begin = reinterpret_cast<const char*>(text.data());
  for (const InvalidSample& sample : invalid_samples()) {
    Json json = Json::parse(begin, begin + text.size());
    sample.spoil(json, json["meshes"][0]["primitives"][0]);
    put(std::string("invalid/") + sample.name + ".gltf", bytes_of(json.dump(2) + "\n"));
  }
}

TEST(GltfSamples, ValidOnesUnpackToACube) {
  if (update_samples) rewrite_samples();
  for (const char* name : {"valid/cube.glb", "valid/cube.gltf", "valid/cube_fallback.glb"}) {
    SCOPED_TRACE(name);
    const auto file = read_file((kFolder / name).string());
    ASSERT_TRUE(file);
    const auto plain = unpack_gltf(*file);
    ASSERT_TRUE(plain) << describe(plain.error());
    EXPECT_EQ(plain->report.converted, 1U);
    const OpenedGlb cube(plain->asset);
    const Json& attributes = cube.primitive()["attributes"];
    const auto positions = cube.values<float>(attributes["POSITION"]);
    ASSERT_EQ(positions.size(), 72U);
    for (const float x : positions) EXPECT_NEAR(std::abs(x), 0.5, 1e-2);
    const auto normals = cube.values<float>(attributes["NORMAL"]);
    for (std::size_t i = 0; i < 24; ++i) {
      const std::size_t axis = std::abs(normals[3 * i]) > 0.9       ? 0
                               : std::abs(normals[3 * i + 1]) > 0.9 ? 1
                                                                    : 2;
      EXPECT_GT(normals[3 * i + axis] * positions[3 * i + axis], 0.48);  // outwards
    }
  }
}

TEST(GltfSamples, PrimitivesOfOneStreamAreGroupsOfItsTriangles) {
  const auto file = read_file((kFolder / "valid/two_materials.gltf").string());
  ASSERT_TRUE(file);
  const auto plain = unpack_gltf(*file);
  ASSERT_TRUE(plain) << describe(plain.error());
  EXPECT_EQ(plain->report.streams, 1U);
  EXPECT_EQ(plain->report.converted, 2U);
  const OpenedGlb cube(plain->asset);
  EXPECT_EQ(cube.values<std::uint16_t>(cube.primitive(0, 0)["indices"]).size(), 30U);
  EXPECT_EQ(cube.values<std::uint16_t>(cube.primitive(0, 1)["indices"]).size(), 6U);
  for (int p = 0; p < 2; ++p) {
    const auto moves = cube.values<float>(cube.primitive(0, p)["targets"][0]["POSITION"]);
    ASSERT_EQ(moves.size(), 72U);
    for (std::size_t i = 0; i < 24; ++i) EXPECT_NEAR(moves[3 * i + 1], 0.25, 1e-2);
  }
}

TEST(GltfSamples, InvalidOnesBreakTheRuleOfTheirName) {
  for (const InvalidSample& sample : invalid_samples()) {
    SCOPED_TRACE(sample.name);
    const auto file = read_file((kFolder / "invalid" / (std::string(sample.name) + ".gltf")).string());
    ASSERT_TRUE(file);
    const auto plain = unpack_gltf(*file);
    ASSERT_FALSE(plain);
    EXPECT_STREQ(plain.error().rule, sample.rule);
  }
}

}  // namespace
}  // namespace deltamesh

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  for (int i = 1; i < argc; ++i) deltamesh::update_samples |= std::strcmp(argv[i], "--update_samples") == 0;
  return RUN_ALL_TESTS();
}
