// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Renumbering of buffer views and the merged buffer.
#include <gtest/gtest.h>

#include <string>

#include "document/compact.h"
#include "document/references.h"
#include "io/gltf/document.h"
#include "support/gltf_asset.h"

namespace deltamesh::gltf {
namespace {

using test::Bytes;
using test::bytes_of;

Document load(const std::string& rest) {
  static std::string text;  // the document refers to it
  text = R"({"asset":{"version":"2.0"},)" + rest + "}";
  auto document = load_document(std::as_bytes(std::span(text)), {});
  EXPECT_TRUE(document) << (document ? "" : document.error().message);
  return document ? *std::move(document) : Document{};
}

std::string bytes_at(const Document& document, std::size_t view) {
  const Json& json = document.json["bufferViews"][view];
  const auto bytes = document.buffers[json["buffer"].get<std::size_t>()].bytes.subspan(
      json.value("byteOffset", std::size_t{0}), json["byteLength"].get<std::size_t>());
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// "0123456789abcdefghijklmnopqrstuv"
constexpr const char* kBuffer =
    R"("buffers":[{"name":"first","byteLength":32,"uri":"data:;base64,MDEyMzQ1Njc4OWFiY2RlZmdoaWprbG1ub3BxcnN0dXY="}])";

TEST(Compact, DropsUnusedViewsAndBytes) {
  Document document =
      load(std::string(kBuffer) +
           R"(,"bufferViews":[{"buffer":0,"byteLength":4},{"buffer":0,"byteOffset":25,"byteLength":3}],
                              "images":[{"bufferView":1}])");
  ASSERT_TRUE(compact_document(document));
  ASSERT_EQ(document.json["bufferViews"].size(), 1U);
  EXPECT_EQ(document.json["images"][0]["bufferView"], 0);
  EXPECT_EQ(bytes_at(document, 0), "pqr");
  EXPECT_EQ(document.json["bufferViews"][0]["byteOffset"].get<int>() % 8, 1);
  EXPECT_LE(document.buffers[0].bytes.size(), 8U);
  EXPECT_EQ(document.json["buffers"][0]["name"], "first");
  EXPECT_FALSE(document.json["buffers"][0].contains("uri"));
}

TEST(Compact, CopiesSharedBytesOnce) {
  std::string views;
  std::string images;
  for (int i = 0; i < 50; ++i) {
    views += std::string(i ? "," : "") + R"({"buffer":0,"byteOffset":)" + std::to_string(i % 3) +
             R"(,"byteLength":29})";
    images += std::string(i ? "," : "") + R"({"bufferView":)" + std::to_string(i) + "}";
  }
  Document document =
      load(std::string(kBuffer) + R"(,"bufferViews":[)" + views + R"(],"images":[)" + images + "]");
  ASSERT_TRUE(compact_document(document));
  EXPECT_EQ(document.json["bufferViews"].size(), 50U);
  EXPECT_LE(document.buffers[0].bytes.size(), 32U);
  EXPECT_EQ(bytes_at(document, 1), "123456789abcdefghijklmnopqrst");
}

TEST(Compact, CopiesBytesThatSeveralBuffersNameOnce) {
  const std::string uri = R"("uri":"data:;base64,MDEyMzQ1Njc4OWFiY2RlZmdoaWprbG1ub3BxcnN0dXY=")";
  std::string buffers;
  std::string views;
  std::string images;
  for (int i = 0; i < 20; ++i) {
    const std::string comma = i ? "," : "";
    buffers += comma + R"({"byteLength":)" + std::to_string(i + 12) + "," + uri + "}";
    views += comma + R"({"buffer":)" + std::to_string(i) + R"(,"byteOffset":)" + std::to_string(i) +
             R"(,"byteLength":12})";
    images += comma + R"({"bufferView":)" + std::to_string(i) + "}";
  }
  Document document =
      load(R"("buffers":[)" + buffers + R"(],"bufferViews":[)" + views + R"(],"images":[)" + images + "]");
  ASSERT_TRUE(compact_document(document));
  ASSERT_EQ(document.buffers.size(), 1U);
  EXPECT_EQ(document.buffers[0].bytes.size(), 31U);
  EXPECT_EQ(bytes_at(document, 0), "0123456789ab");
  EXPECT_EQ(bytes_at(document, 19), "jklmnopqrstu");
}

TEST(Compact, FollowsViewsInsideUnknownExtensionsAndLeavesExtras) {
  Document document =
      load(std::string(kBuffer) +
           R"(,"bufferViews":[{"buffer":0,"byteLength":2},{"buffer":0,"byteOffset":4,"byteLength":2}],
                              "nodes":[{"extensions":{"X_audio":{"clip":{"bufferView":1}}},"extras":{"bufferView":77,"buffer":9}}])");
  ASSERT_TRUE(compact_document(document));
  ASSERT_EQ(document.json["bufferViews"].size(), 1U);
  EXPECT_EQ(document.json["nodes"][0]["extensions"]["X_audio"]["clip"]["bufferView"], 0);
  EXPECT_EQ(bytes_at(document, 0), "45");
  EXPECT_EQ(document.json["nodes"][0]["extras"].dump(), R"({"bufferView":77,"buffer":9})");
}

TEST(Compact, KeepsNumbersThatUnknownExtensionsMayMean) {
  // Views 1 and 3 may be meant by "values" and "offsets"; 0 and 2 are not used, 4 is.
  Document document = load(
      std::string(kBuffer) +
      R"(,"bufferViews":[{"buffer":0,"byteLength":1},{"buffer":0,"byteOffset":1,"byteLength":1},{"buffer":0,"byteOffset":2,"byteLength":1},
          {"buffer":0,"byteOffset":3,"byteLength":1},{"buffer":0,"byteOffset":4,"byteLength":1}],
         "images":[{"bufferView":4}],"extensions":{"X_tables":{"values":1,"offsets":3,"count":900}})");
  ASSERT_TRUE(compact_document(document));
  ASSERT_EQ(document.json["bufferViews"].size(), 4U);
  EXPECT_EQ(bytes_at(document, 1), "1");
  EXPECT_EQ(bytes_at(document, 3), "3");
  const auto image = document.json["images"][0]["bufferView"].get<std::size_t>();
  EXPECT_EQ(image, 0U);
  EXPECT_EQ(bytes_at(document, image), "4");
}

TEST(Compact, KeepsOpaqueBuffersAndTheirReferences) {
  Document document = load(
      R"("buffers":[{"byteLength":1000,"extensions":{"EXT_meshopt_compression":{"fallback":true}}},
                    {"byteLength":32,"uri":"data:;base64,MDEyMzQ1Njc4OWFiY2RlZmdoaWprbG1ub3BxcnN0dXY="}],
         "bufferViews":[{"buffer":1,"byteLength":2},
                        {"buffer":0,"byteOffset":100,"byteLength":900,
                         "extensions":{"EXT_meshopt_compression":{"buffer":1,"byteOffset":16,"byteLength":8,"count":9}}}],
         "accessors":[{"bufferView":1}])");
  ASSERT_TRUE(compact_document(document));
  ASSERT_EQ(document.buffers.size(), 2U);
  EXPECT_TRUE(document.buffers[1].opaque);
  EXPECT_EQ(document.json["buffers"][1]["byteLength"], 1000);
  const Json& view = document.json["bufferViews"][0];
  EXPECT_EQ(view["buffer"], 1);
  EXPECT_EQ(view["byteOffset"], 100);
  const Json& inner = view["extensions"]["EXT_meshopt_compression"];
  EXPECT_EQ(inner["buffer"], 0);
  EXPECT_EQ(inner["count"], 9);
  const auto bytes = document.buffers[0].bytes.subspan(inner["byteOffset"].get<std::size_t>(), 8);
  EXPECT_EQ(bytes[0], std::byte{'g'});
}

TEST(Compact, AssetsWithoutDataLoseEmptyLists) {
  Document document = load(std::string(kBuffer) + R"(,"bufferViews":[{"buffer":0,"byteLength":4}])");
  ASSERT_TRUE(compact_document(document));
  EXPECT_FALSE(document.json.contains("bufferViews"));
  EXPECT_FALSE(document.json.contains("buffers"));
}

TEST(Compact, RefusesReferencesOutOfRange) {
  for (
      const char* rest :
      {R"(,"images":[{"bufferView":0}])",
       R"(,"bufferViews":[{"buffer":0,"byteLength":1}],"images":[{"bufferView":1}])",
       R"(,"bufferViews":[{"buffer":0,"byteLength":1}],"images":[{"bufferView":-1}])",
       R"(,"bufferViews":[{"buffer":1,"byteLength":1}],"images":[{"bufferView":0}])",
       R"(,"bufferViews":[{"buffer":0,"byteLength":33}],"images":[{"bufferView":0}])",
       R"(,"bufferViews":[{"buffer":0,"byteLength":0}],"images":[{"bufferView":0}])",
       R"(,"bufferViews":[{"buffer":0,"byteOffset":32,"byteLength":1}],"images":[{"bufferView":0}])",
       R"(,"bufferViews":[{"buffer":0,"byteOffset":18446744073709551615,"byteLength":2}],"images":[{"bufferView":0}])"}) {
    Document document = load(std::string(kBuffer) + rest);
    const auto result = compact_document(document);
    ASSERT_FALSE(result) << rest;
    EXPECT_EQ(result.error().code, ErrorCode::kInvalidFile);
  }
}

TEST(References, KnownExtensionsHoldNoNumbersOfOurs) {
  EXPECT_TRUE(is_harmless_extension("KHR_materials_clearcoat"));
  EXPECT_TRUE(is_harmless_extension("KHR_texture_transform"));
  EXPECT_FALSE(is_harmless_extension("KHR_materials"));
  EXPECT_FALSE(is_harmless_extension("EXT_mesh_gpu_instancing"));
  Json json = Json::parse(
      R"({"nodes":[{"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":4,"bufferView":8}},
                              "KHR_lights_punctual":{"light":7}},"extras":{"extensions":{"X":{"a":9}}}}]})");
  EXPECT_EQ(numbers_in_unknown_extensions(json), std::set<std::uint64_t>{4});
}

}  // namespace
}  // namespace deltamesh::gltf
