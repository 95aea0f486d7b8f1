// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Bounds on texture coordinates count behind KHR_texture_transform: readers tell by how much that stretches.
#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "io_support.h"

namespace deltamesh::texture_transform_test {
namespace {

std::string transform(const std::string& scale) {
  return R"({"index":0,"extensions":{"KHR_texture_transform":{"scale":)" + scale + "}}}";
}

TEST(TextureTransforms, StretchByTheLargestFactorOfAMaterialThatIsShown) {
  const auto plain = write_mesh(test::dressed_mesh(), FileFormat::kGltf);
  ASSERT_TRUE(plain);
  const std::string base = R"({"pbrMetallicRoughness":{"baseColorTexture":)" + transform("[50,2]") + "}}";
  const std::string coat =
      R"({"extensions":{"KHR_materials_clearcoat":{"clearcoatTexture":)" + transform("[1,-10]") + "}}}";
  const std::string variants =
      R"("extensions":{"KHR_materials_variants":{"mappings":[{"variants":[0],"material":1}]}})";
  const std::vector<std::tuple<std::string, std::string, double>> cases{
      {base, R"("material":0)", 50},
      {R"({"normalTexture":)" + transform("[1,20]") + "}", R"("material":0)", 20},
      {coat, R"("material":0)", 10},
      {"{}," + base, R"("material":0,)" + variants, 50},
      {"{}," + base, R"("material":0)", 1},
      {R"({"emissiveTexture":)" + transform("[0.25,0.5]") + "}", R"("material":0)", 1},
      {R"({"emissiveTexture":)" + transform(R"("wide")") + "}", R"("material":0)", 1},
      {base, R"("material":7)", 1}};
  for (const auto& [materials, shown, scale] : cases) {
    std::string text = test::text_of(*plain);
    text.insert(1, R"("textures":[{}],"materials":[)" + materials + "],");
    text.insert(text.find(R"("mode":4)"), shown + ",");
    const auto imported = test::read_text(text, FileFormat::kGltf);
    ASSERT_TRUE(imported) << describe(imported.error());
    EXPECT_EQ(imported->report.uv_scale, scale) << materials;
  }
}

}  // namespace
}  // namespace deltamesh::texture_transform_test
