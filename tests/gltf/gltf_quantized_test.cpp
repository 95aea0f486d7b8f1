// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// KHR_mesh_quantization and other integers in attributes, and assets that another extension has compressed.
#include <gtest/gtest.h>

#include <string>

#include "asset_compare.h"
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
using test::OpenedGlb;
using test::pack_ok;
using test::positions_of;
using test::Sheet;
using test::unpack_ok;

constexpr std::size_t kSide = 12;

template <class T>
constexpr int kComponentType = 0;
template <>
constexpr int kComponentType<std::int8_t> = 5120;
template <>
constexpr int kComponentType<std::uint8_t> = 5121;
template <>
constexpr int kComponentType<std::int16_t> = 5122;
template <>
constexpr int kComponentType<std::uint16_t> = 5123;

/// Rows of `components` integers, padded to a multiple of four bytes.
template <class T>
std::size_t integers(GltfBuilder& builder, const std::vector<T>& values, std::size_t components,
                     bool normalized) {
  const std::size_t stride = (components * sizeof(T) + 3) / 4 * 4;
  Bytes bytes(values.size() / components * stride);
  for (std::size_t i = 0; i < values.size() / components; ++i)
    std::memcpy(bytes.data() + i * stride, values.data() + i * components, components * sizeof(T));
  const std::size_t view = builder.view(bytes, 34962);
  builder.json["bufferViews"][view]["byteStride"] = stride;
  Json item{{"bufferView", view},
            {"componentType", kComponentType<T>},
            {"normalized", normalized},
            {"count", values.size() / components},
            {"type", components == 2 ? "VEC2" : "VEC3"}};
  return builder.push("accessors", item);
}

/// The sheet with positions in integers, those of the type's range that fit.
template <class T>
std::vector<T> quantised(const std::vector<float>& values) {
  const float top = static_cast<float>(std::numeric_limits<T>::max());
  std::vector<T> integers;
  for (const float x : values)
    integers.push_back(static_cast<T>(std::lround(std::max(x, 0.0F) * top * 0.8F)));
  return integers;
}

template <class T>
class GltfQuantized : public testing::Test {};
using Types = testing::Types<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t>;
TYPED_TEST_SUITE(GltfQuantized, Types);

TYPED_TEST(GltfQuantized, PositionsBecomeTheFloatsThatTheyStandFor) {
  for (const bool normalized : {false, true}) {
    GltfBuilder builder;
    const Sheet sheet = make_sheet(kSide);
    builder.sheet_mesh(sheet);
    const auto positions = quantised<TypeParam>(sheet.positions);
    Json& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["POSITION"] = integers(builder, positions, 3, normalized);
    builder.json["extensionsUsed"] = {"KHR_mesh_quantization"};
    builder.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    GltfPackOptions options;
    options.encode.lossless = true;
    options.encode.keep_order = true;
    const GltfOutput packed = pack_ok(builder.glb(), options);
    EXPECT_EQ(packed.report.converted, 1U);
    const OpenedGlb plain(unpack_ok(packed.asset).asset);
    EXPECT_FALSE(plain.json.contains("extensionsUsed"));  // nothing needs it any more
    const Json& accessor =
        plain.json["accessors"][plain.primitive()["attributes"]["POSITION"].get<std::size_t>()];
    EXPECT_EQ(accessor["componentType"], 5126);
    EXPECT_FALSE(accessor.contains("normalized"));
    const auto after = positions_of(plain, plain.primitive());
    ASSERT_EQ(after.size(), positions.size());
    const float top = static_cast<float>(std::numeric_limits<TypeParam>::max());
    for (std::size_t i = 0; i < after.size(); ++i) {
      const float value = static_cast<float>(positions[i]);
      EXPECT_EQ(after[i], normalized ? value / top : value);
    }
  }
}

TEST(GltfPack, OtherIntegersStayExactAndTheExtensionThatTheyNeed) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(kSide));
  const std::size_t n = kSide * kSide;
  std::vector<std::int8_t> normals(3 * n);
  std::vector<std::uint16_t> uvs(2 * n);
  std::vector<std::int16_t> moves(3 * n);
  for (std::size_t i = 0; i < normals.size(); ++i) normals[i] = static_cast<std::int8_t>(i * 7 % 255 - 127);
  for (std::size_t i = 0; i < uvs.size(); ++i) uvs[i] = static_cast<std::uint16_t>(i * 97);
  for (std::size_t i = 0; i < moves.size(); ++i) moves[i] = static_cast<std::int16_t>(i % 500) - 250;
  Json& primitive = builder.json["meshes"][0]["primitives"][0];
  Json attributes = primitive["attributes"];
  attributes["NORMAL"] = integers(builder, normals, 3, true);
  attributes["TEXCOORD_0"] = integers(builder, uvs, 2, true);
  primitive["attributes"] = attributes;
  primitive["targets"] = Json::array({Json{{"POSITION", integers(builder, moves, 3, false)}}});
  builder.json["extensionsUsed"] = {"KHR_mesh_quantization"};
  GltfPackOptions options;
  options.encode.keep_order = true;
  options.encode.attributes.normal_error = 10;
  options.encode.attributes.uv_error = 0.1;
  options.encode.quality.max_error = QualityBound{.value = 10, .unit = QualityUnit::kDiagonal};
  const OpenedGlb plain(unpack_ok(pack_ok(builder.glb(), options).asset).asset);
  const Json& after = plain.primitive();
  EXPECT_EQ(plain.values<std::int8_t>(after["attributes"]["NORMAL"]), normals);
  EXPECT_EQ(plain.values<std::uint16_t>(after["attributes"]["TEXCOORD_0"]), uvs);
  EXPECT_EQ(plain.values<std::int16_t>(after["targets"][0]["POSITION"]), moves);
  EXPECT_EQ(plain.json["accessors"][after["attributes"]["NORMAL"].get<std::size_t>()]["normalized"], true);
  EXPECT_EQ(plain.json["extensionsUsed"], Json::array({"KHR_mesh_quantization"}));
}

/// A sheet whose primitive claims to be in a Draco stream.
void add_draco(GltfBuilder& builder) {
  const std::size_t mesh = builder.sheet_mesh(make_sheet(4));
  builder.json["meshes"][mesh]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
      {"bufferView", 0}, {"attributes", {{"POSITION", 0}}}};
  builder.json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
}

TEST(GltfPackErrors, CompressedAssetsAreToBeDecompressedFirst) {
  GltfBuilder builder;
  add_draco(builder);
  const auto draco = pack_gltf(builder.glb(), {});
  ASSERT_FALSE(draco);
  EXPECT_EQ(draco.error().code, ErrorCode::kInvalidFile);
  EXPECT_NE(std::string(draco.error().message).find("Draco"), std::string::npos);
  EXPECT_NE(std::string(draco.error().message).find("gltf-transform cp"), std::string::npos);
  builder.sheet_mesh(make_sheet(4));
  const GltfReport report = pack_ok(builder.glb()).report;
  EXPECT_EQ(report.converted, 1U);
  EXPECT_EQ(report.otherwise_compressed, 1U);

  for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    GltfBuilder meshopt;
    meshopt.sheet_mesh(make_sheet(4));
    for (Json& view : meshopt.json["bufferViews"])
      view["extensions"][name] = {{"buffer", 0}, {"byteLength", 9}};
    meshopt.json["extensionsUsed"] = {name};
    const auto result = pack_gltf(meshopt.glb(), {});
    ASSERT_FALSE(result);
    EXPECT_NE(std::string(result.error().message).find("meshoptimizer"), std::string::npos);
  }
}

}  // namespace
}  // namespace deltamesh
