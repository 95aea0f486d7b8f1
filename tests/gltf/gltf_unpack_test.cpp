// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Unpacking assets that break the extension's rules, hostile assets, and limits.
#include <gtest/gtest.h>

#include <string>

#include "deltamesh/gltf.h"
#include "gltf_packing.h"
#include "support/gltf_asset.h"

namespace deltamesh {
namespace {

using test::Bytes;
using test::GltfBuilder;
using test::Json;
using test::kExtension;
using test::make_sheet;
using test::OpenedGlb;

/// A packed sheet, taken apart so that a test can spoil it.
class GltfUnpackRules : public testing::Test {
 protected:
  void SetUp() override {
    GltfBuilder builder;
    builder.sheet_mesh(make_sheet(6));
    const auto packed = pack_gltf(builder.glb(), {});
    ASSERT_TRUE(packed);
    const OpenedGlb opened(packed->asset);
    original_ = opened.json;
    bin_ = opened.bin;
    reset();
  }
  void reset() {
    json_ = original_;
    extension_ = &json_["meshes"][0]["primitives"][0]["extensions"][kExtension];
    primitive_ = &json_["meshes"][0]["primitives"][0];
  }
  Bytes asset() const { return GltfBuilder::glb_of(json_.dump(), bin_); }
  /// The rule that unpacking names; "none" where it succeeds. Starts over afterwards.
  std::string broken_rule() {
    const auto result = unpack_gltf(asset());
    reset();
    if (result) return "none";
    EXPECT_EQ(result.error().code, ErrorCode::kInvalidFile) << describe(result.error());
    return result.error().rule;
  }

  Json original_;
  Json json_;
  Bytes bin_;
  Json* extension_ = nullptr;
  Json* primitive_ = nullptr;
};

TEST_F(GltfUnpackRules, GLTF1RefusesViewsThatHoldNoStream) {
  EXPECT_EQ(broken_rule(), "none");
  extension_->erase("bufferView");
  EXPECT_EQ(broken_rule(), "GLTF-1");
  (*extension_)["bufferView"] = -1;
  EXPECT_EQ(broken_rule(), "GLTF-1");
  (*extension_)["bufferView"] = 0.5;
  EXPECT_EQ(broken_rule(), "GLTF-1");
  (*extension_)["bufferView"] = 7;
  EXPECT_EQ(broken_rule(), "");
  json_["bufferViews"][0]["extensions"] = {{"EXT_meshopt_compression", Json::object()}};
  EXPECT_EQ(broken_rule(), "GLTF-1");
  (*primitive_)["extensions"][kExtension] = 1;
  EXPECT_EQ(broken_rule(), "GLTF-1");
}

TEST_F(GltfUnpackRules, GLTF2RefusesOtherModes) {
  (*primitive_)["mode"] = 4;
  EXPECT_EQ(broken_rule(), "none");
  for (const int mode : {0, 1, 5, 6, 7, -4}) {
    (*primitive_)["mode"] = mode;
    EXPECT_EQ(broken_rule(), "GLTF-2") << mode;
  }
}

TEST_F(GltfUnpackRules, GLTF3NeedsPositionAndIndices) {
  primitive_->erase("indices");
  EXPECT_EQ(broken_rule(), "GLTF-3");
  (*primitive_)["attributes"].erase("POSITION");
  EXPECT_EQ(broken_rule(), "GLTF-3");
}

TEST_F(GltfUnpackRules, GLTF4ChecksAttributes) {
  (*extension_)["attributes"]["POSITION"] = 0;
  EXPECT_EQ(broken_rule(), "GLTF-4");
  (*extension_)["attributes"]["TANGENT"] = 0;
  EXPECT_EQ(broken_rule(), "GLTF-4");
  (*extension_)["attributes"]["NORMAL"] = 2;
  EXPECT_EQ(broken_rule(), "GLTF-4");
  (*extension_)["attributes"]["NORMAL"] = "0";
  EXPECT_EQ(broken_rule(), "GLTF-4");
  (*extension_)["attributes"] = Json::array();
  EXPECT_EQ(broken_rule(), "GLTF-4");
}

TEST_F(GltfUnpackRules, GLTF4ChecksMorphTargets) {
  const std::size_t normal = (*primitive_)["attributes"]["NORMAL"];
  const auto with_targets = [&](const Json& ids) {
    (*extension_)["targets"] = ids;
    (*primitive_)["targets"] = Json::array({Json{{"NORMAL", normal}}});  // moves the extension
    return broken_rule();
  };
  EXPECT_EQ(with_targets(Json::array({Json{{"NORMAL", 0}}})), "none");
  EXPECT_EQ(with_targets(Json::array()), "none");
  EXPECT_EQ(with_targets(Json{{"NORMAL", 0}}), "GLTF-4");
  EXPECT_EQ(with_targets(Json::array({0})), "GLTF-4");
  EXPECT_EQ(with_targets(Json::array({Json{{"POSITION", 0}}})), "GLTF-4");
  EXPECT_EQ(with_targets(Json::array({Json{{"NORMAL", 2}}})), "GLTF-4");
  EXPECT_EQ(with_targets(Json::array({Json{{"NORMAL", -1}}})), "GLTF-4");
  EXPECT_EQ(with_targets(Json::array({Json{{"NORMAL", 0}}, Json{{"NORMAL", 0}}})), "GLTF-4");
  (*extension_)["targets"] = Json::array({Json::object()});
  EXPECT_EQ(broken_rule(), "GLTF-4");
}

TEST_F(GltfUnpackRules, GLTF11NeedsTrianglesInTheGroup) {
  (*extension_)["group"] = 0;
  EXPECT_EQ(broken_rule(), "none");
  for (const Json& group : {Json(1), Json(-1), Json("0"), Json(1ULL << 40)}) {
    (*extension_)["group"] = group;
    EXPECT_EQ(broken_rule(), "GLTF-11") << group;
  }
}

TEST_F(GltfUnpackRules, GLTF5ComparesAccessorsWithTheStream) {
  const std::size_t position = (*primitive_)["attributes"]["POSITION"];
  const std::size_t normal = (*primitive_)["attributes"]["NORMAL"];
  const std::size_t indices = (*primitive_)["indices"];
  json_["accessors"][position]["count"] = 35;
  EXPECT_EQ(broken_rule(), "GLTF-5");
  json_["accessors"][normal]["type"] = "VEC4";
  EXPECT_EQ(broken_rule(), "GLTF-5");
  json_["accessors"][normal]["componentType"] = 5123;
  EXPECT_EQ(broken_rule(), "GLTF-5");
  json_["accessors"][indices]["count"] = 3;
  EXPECT_EQ(broken_rule(), "GLTF-5");
  json_["accessors"][indices]["componentType"] = 5126;
  EXPECT_EQ(broken_rule(), "GLTF-5");
  json_["accessors"][indices]["componentType"] = 5122;
  EXPECT_EQ(broken_rule(), "GLTF-5");
  for (const int wide_enough : {5121, 5123, 5125}) {
    json_["accessors"][indices]["componentType"] = wide_enough;
    EXPECT_EQ(broken_rule(), "none");
  }
  (*extension_)["attributes"]["NORMAL"] = 1;  // the texture coordinates
  EXPECT_EQ(broken_rule(), "GLTF-5");
}

TEST_F(GltfUnpackRules, GLTF6RefusesAccessorsWithTwoMeanings) {
  (*primitive_)["attributes"]["NORMAL"] = (*primitive_)["attributes"]["POSITION"];
  EXPECT_EQ(broken_rule(), "GLTF-6");
  // Two streams into the same accessors: a second view over the same bytes counts as another stream.
  json_["bufferViews"].push_back(json_["bufferViews"][0]);
  Json second = *primitive_;
  second["extensions"][kExtension]["bufferView"] = 1;
  json_["meshes"][0]["primitives"].push_back(second);
  EXPECT_EQ(broken_rule(), "GLTF-6");
}

TEST_F(GltfUnpackRules, GLTF7RefusesAnOrigin) {
  const auto view = OpenedGlb(asset()).view(0);
  auto mesh = decode(view);
  ASSERT_TRUE(mesh);
  mesh->origin = {1e6, 0, 0};
  const auto stream = encode(*mesh);
  ASSERT_TRUE(stream);
  bin_ = stream->bytes;
  json_["buffers"][0]["byteLength"] = bin_.size();
  json_["bufferViews"][0]["byteLength"] = bin_.size();
  EXPECT_EQ(broken_rule(), "GLTF-7");
}

TEST_F(GltfUnpackRules, StreamErrorsAreHandedOn) {
  bin_[40] ^= std::byte{1};
  const auto result = unpack_gltf(asset());
  ASSERT_FALSE(result);
  EXPECT_LT(static_cast<int>(result.error().code), 200);
}

TEST_F(GltfUnpackRules, SharedArraysAreStoredOnce) {
  // Twenty primitives of one stream, each with accessors of its own.
  Json& primitives = json_["meshes"][0]["primitives"];
  for (int i = 0; i < 20; ++i) {
    Json copy = primitives[0];
    for (Json* number : {&copy["attributes"]["POSITION"], &copy["attributes"]["NORMAL"], &copy["indices"]}) {
      json_["accessors"].push_back(Json(json_["accessors"][number->get<std::size_t>()]));
      *number = json_["accessors"].size() - 1;
    }
    json_["meshes"][0]["primitives"].push_back(copy);
  }
  const auto result = unpack_gltf(asset());
  ASSERT_TRUE(result) << describe(result.error());
  EXPECT_EQ(result->report.converted, 21U);
  EXPECT_EQ(result->report.streams, 1U);
  EXPECT_EQ(OpenedGlb(result->asset).json["bufferViews"].size(), 4U);
}

TEST_F(GltfUnpackRules, LimitsHoldForTheSumOfAllStreams) {
  DecodeOptions options;
  options.limits.vertices = 36;
  ASSERT_TRUE(unpack_gltf(asset(), options));
  // A second stream, with accessors of its own.
  json_["bufferViews"].push_back(json_["bufferViews"][0]);
  const std::size_t first = json_["accessors"].size();
  for (std::size_t i = 0; i < first; ++i) json_["accessors"].push_back(Json(json_["accessors"][i]));
  Json second = json_["meshes"][0]["primitives"][0];
  for (Json& accessor : second["attributes"]) accessor = accessor.get<std::size_t>() + first;
  second["indices"] = second["indices"].get<std::size_t>() + first;
  second["extensions"][kExtension]["bufferView"] = 1;
  json_["meshes"][0]["primitives"].push_back(second);
  ASSERT_TRUE(unpack_gltf(asset()));
  const auto refused = unpack_gltf(asset(), options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kLimitExceeded);
}

TEST_F(GltfUnpackRules, AssetsWithoutTheExtensionPassThrough) {
  const auto plain = unpack_gltf(asset());
  ASSERT_TRUE(plain);
  const auto again = unpack_gltf(plain->asset);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->report.converted, 0U);
  EXPECT_EQ(again->asset, plain->asset);
}

TEST_F(GltfUnpackRules, EveryByteFlippedEndsInAnErrorOrAnAsset) {
  const Bytes good = asset();
  DecodeOptions options;
  options.limits.vertices = 10000;
  options.limits.triangles = 10000;
  for (std::size_t i = 0; i < good.size(); ++i) {
    Bytes bad = good;
    bad[i] ^= std::byte{0x11};
    const auto result = unpack_gltf(bad, options);
    const ErrorCode code = result ? ErrorCode::kInvalidFile : result.error().code;
    EXPECT_NE(code, ErrorCode::kInternal) << i;
  }
}

}  // namespace
}  // namespace deltamesh
