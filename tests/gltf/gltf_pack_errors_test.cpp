// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What packing refuses, and how it says so.
#include <gtest/gtest.h>

#include <limits>
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
using test::make_sheet;
using test::Sheet;

Error pack_error(const Bytes& asset, const GltfPackOptions& options = {}) {
  const auto result = pack_gltf(asset, options);
  return result ? Error{.message = "no error"} : result.error();
}

TEST(GltfPackErrors, OptionsAreChecked) {
  GltfPackOptions options;
  options.encode.bits = 99;
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(4));
  EXPECT_EQ(pack_error(builder.glb(), options).code, ErrorCode::kInvalidArgument);
}

TEST(GltfPackErrors, NameThePrimitive) {
  GltfBuilder good;
  good.sheet_mesh(make_sheet(4));
  good.sheet_mesh(make_sheet(4));
  Sheet sheet = make_sheet(4);

  GltfBuilder beyond = good;
  sheet.triangles[5] = 16;
  beyond.sheet_mesh(sheet);
  Error error = pack_error(beyond.glb());
  EXPECT_EQ(error.code, ErrorCode::kInvalidFile);
  EXPECT_EQ(describe(error), "a vertex index beyond the primitive's vertices: 'mesh 2, primitive 0'");

  GltfBuilder nan = good;
  sheet = make_sheet(4);
  sheet.positions[16] = std::numeric_limits<float>::quiet_NaN();
  nan.sheet_mesh(sheet);
  error = pack_error(nan.glb());
  EXPECT_EQ(error.code, ErrorCode::kNotFinite);
  EXPECT_EQ(describe(error), "a coordinate is NaN or infinite: 'mesh 2, primitive 0', vertex 5");

  GltfBuilder counts = good;
  Json& primitives = counts.json["meshes"][1]["primitives"];
  primitives.push_back(primitives[0]);
  primitives[1]["attributes"]["TEXCOORD_0"] = counts.floats({0, 0}, 2);
  EXPECT_EQ(
      describe(pack_error(counts.glb())),
      "the attributes of a primitive differ in their number of values: 'mesh 1, primitive 1', accessor 8");
}

TEST(GltfPackErrors, RefuseAccessorsThatLie) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(4));
  const Json original = builder.json;
  const auto broken = [&](auto&& change) {
    builder.json = original;
    change(builder.json);
    return pack_error(builder.glb()).code;
  };
  const auto kBad = ErrorCode::kInvalidFile;
  EXPECT_EQ(broken([](Json& j) { j["accessors"][0]["count"] = 17; }), kBad);
  EXPECT_EQ(broken([](Json& j) { j["accessors"][0]["count"] = 1ULL << 62; }), kBad);
  EXPECT_EQ(broken([](Json& j) { j["accessors"][0]["count"] = 0; }), kBad);
  EXPECT_EQ(broken([](Json& j) { j["accessors"][0]["count"] = -16; }), kBad);
  EXPECT_EQ(broken([](Json& j) { j["accessors"][0].erase("count"); }), kBad);
  EXPECT_EQ(broken([](Json& j) { j["accessors"][0]["type"] = 3; }), kBad);
  EXPECT_EQ(broken([](Json& j) { j["accessors"][0]["byteOffset"] = 1; }), kBad);
  EXPECT_EQ(broken([](Json& j) { j["accessors"][0]["byteOffset"] = ~0ULL; }), kBad);
  EXPECT_EQ(broken([](Json& j) { j["accessors"][0]["bufferView"] = 99; }), kBad);
  EXPECT_EQ(broken([](Json& j) { j["accessors"][0]["bufferView"] = "x"; }), kBad);
  EXPECT_EQ(broken([](Json& j) { j["accessors"][1]["count"] = 15; }), kBad);
  EXPECT_EQ(broken([](Json& j) { j["accessors"][3]["componentType"] = 5126; }), kBad);
  EXPECT_EQ(broken([](Json& j) { j["bufferViews"][0]["byteStride"] = 8; }), kBad);
  EXPECT_EQ(broken([](Json& j) { j["bufferViews"][0]["byteStride"] = ~0ULL; }), kBad);
  EXPECT_EQ(broken([](Json& j) { j["bufferViews"][0]["byteLength"] = ~0ULL; }), kBad);
  EXPECT_EQ(broken([](Json& j) { j["bufferViews"][0]["buffer"] = 4; }), kBad);
  EXPECT_EQ(broken([](Json& j) { j["meshes"][0]["primitives"][0]["mode"] = 7; }), kBad);
  EXPECT_EQ(broken([](Json& j) { j["accessors"][0]["sparse"] = {{"count", 99}}; }), kBad);
  EXPECT_EQ(broken([](Json& j) {
              j["accessors"][0]["sparse"] = {
                  {"count", 1},
                  {"indices", {{"bufferView", 3}, {"byteOffset", 20}, {"componentType", 5125}}},
                  {"values", {{"bufferView", 0}, {"byteOffset", 999}}}};
            }),
            kBad);
}

TEST(GltfPackErrors, EmptyAndForeignInput) {
  EXPECT_EQ(pack_error({}).code, ErrorCode::kInvalidFile);
  EXPECT_EQ(pack_error(bytes_of(std::string("DMSH"))).code, ErrorCode::kInvalidFile);
  EXPECT_EQ(pack_error(Bytes(1000)).code, ErrorCode::kInvalidFile);
  EXPECT_STREQ(pack_error(bytes_of(std::string("ply\nformat ascii 1.0\n"))).message,
               "neither a GLB nor the JSON text of a glTF asset");
}

}  // namespace
}  // namespace deltamesh
