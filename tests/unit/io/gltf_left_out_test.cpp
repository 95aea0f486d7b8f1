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

}  // namespace
}  // namespace deltamesh::gltf_left_out_test
