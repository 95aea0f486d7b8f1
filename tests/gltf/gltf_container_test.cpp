// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// URIs, JSON limits, GLB and the loading of documents.
#include <gtest/gtest.h>

#include <string>

#include "document/references.h"
#include "io/gltf/document.h"
#include "io/gltf/glb.h"
#include "io/gltf/json.h"
#include "io/gltf/uri.h"
#include "support/gltf_asset.h"

namespace deltamesh::gltf {
namespace {

using test::Bytes;
using test::bytes_of;
using test::GltfBuilder;

TEST(Uri, DataUrisMatchTheVectorsOfRfc4648) {
  const std::array<std::pair<std::string, std::string>, 7> kVectors{{{"", ""},
                                                                     {"f", "Zg=="},
                                                                     {"fo", "Zm8="},
                                                                     {"foo", "Zm9v"},
                                                                     {"foob", "Zm9vYg=="},
                                                                     {"fooba", "Zm9vYmE="},
                                                                     {"foobar", "Zm9vYmFy"}}};
  for (const auto& [plain, coded] : kVectors) {
    EXPECT_EQ(data_uri_of(bytes_of(plain)), "data:application/octet-stream;base64," + coded);
    EXPECT_EQ(decode_data_uri("data:;base64," + coded), bytes_of(plain));
  }
}

TEST(Uri, OfANameLeadsBackToTheName) {
  for (const std::string name : {"plain.bin", "my box.bin", "50%.bin", "a:b#c?.bin", "\xc3\xa9.bin"})
    EXPECT_EQ(relative_path_of(uri_of_name(name)), name);
  for (const char* uri : {"http://host/a.bin", "C:a.bin", "a%2F..%2F..%2Fb", "%2Fetc/passwd"})
    EXPECT_FALSE(relative_path_of(uri)) << uri;
}

TEST(GltfJson, KeepsMembersNumbersAndOrder) {
  const std::string text =
      R"({"z":1,"a":[0.1,1e-7,-0.0,18446744073709551615,-9223372036854775808,1.0],"m":"\u00e9"})";
  const auto json = parse_json(bytes_of(text));
  ASSERT_TRUE(json);
  EXPECT_EQ(json->dump(),
            R"({"z":1,"a":[0.1,1e-07,-0.0,18446744073709551615,-9223372036854775808,1.0],"m":"é"})");
}

TEST(GltfJson, RefusesDepthAndNonsense) {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_TRUE(parse_json(bytes_of(nested(kMaxJsonDepth))));
  const auto deep = parse_json(bytes_of(nested(kMaxJsonDepth + 1)));
  ASSERT_FALSE(deep);
  EXPECT_EQ(deep.error().code, ErrorCode::kLimitExceeded);
  EXPECT_EQ(deep.error().where, kMaxJsonDepth);
  EXPECT_FALSE(parse_json(bytes_of(std::string(10'000'000, '['))));
  for (const char* text : {"", "{", "{}}", "\"\\", "{\"a\":}", "nul", "{\"a\":1e999}", "\"\xff\"", "[1,]"})
    EXPECT_FALSE(parse_json(bytes_of(std::string(text)))) << text;
}

TEST(GltfJson, RefusesObjectsWithTooManyMembers) {
  const auto object = [](std::size_t members) {
    std::string text = "{";
    for (std::size_t i = 0; i < members; ++i) text += (i ? ",\"" : "\"") + std::to_string(i) + "\":0";
    return bytes_of(text + "}");
  };
  EXPECT_TRUE(parse_json(object(1000)));
  const auto result = parse_json(object(kMaxJsonMembers + 1));
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kLimitExceeded);
}

TEST(Glb, RoundTripsWithUnknownChunks) {
  const Bytes bin = bytes_of(std::string("12345"));
  const Bytes extra = bytes_of(std::string("abcd"));
  const std::array<GlbChunk, 1> others{{{0x58585858, extra}}};
  const auto file = write_glb("{}", bin, others);
  ASSERT_TRUE(file);
  EXPECT_EQ(file->size() % 4, 0U);
  const auto glb = parse_glb(*file);
  ASSERT_TRUE(glb);
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(glb->json.data()), glb->json.size()), "{}  ");
  ASSERT_TRUE(glb->bin);
  EXPECT_EQ(glb->bin->size(), 8U);
  ASSERT_EQ(glb->others.size(), 1U);
  EXPECT_EQ(glb->others[0].type, 0x58585858U);
  EXPECT_TRUE(std::equal(extra.begin(), extra.end(), glb->others[0].bytes.begin()));
}

TEST(Glb, EveryPrefixFailsAndBytesBehindTheEndAreLeftAlone) {
  GltfBuilder builder;
  builder.sheet_mesh(test::make_sheet(3));
  const Bytes file = builder.glb();
  ASSERT_TRUE(parse_glb(file));
  for (std::size_t size = 0; size < file.size(); ++size) {
    const Bytes prefix(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_FALSE(parse_glb(prefix)) << size;
  }
  Bytes longer = file;
  longer.push_back(std::byte{0});
  const auto glb = parse_glb(longer);
  ASSERT_TRUE(glb);
  EXPECT_TRUE(glb->others.empty());
}

TEST(Glb, RefusesOtherVersionsAndOrders) {
  const Bytes good = GltfBuilder::glb_of("{}", Bytes(4));
  for (const std::size_t byte : {0U, 4U, 16U}) {  // magic, version, type of the first chunk
    Bytes bad = good;
    bad[byte] ^= std::byte{1};
    EXPECT_FALSE(parse_glb(bad)) << byte;
  }
  EXPECT_FALSE(parse_glb(GltfBuilder::glb_of("", {})));
}

Error load_error(const std::string& text) {
  const Bytes bytes = bytes_of(text);
  const auto document = load_document(bytes, {});
  return document ? Error{.message = "no error"} : document.error();
}

TEST(Document, RefusesMalformedStructure) {
  const std::string asset = R"({"asset":{"version":"2.0"},)";
  for (const char* rest : {R"("buffers":{}})",
                           R"("buffers":[1]})",
                           R"("buffers":[{}]})",
                           R"("buffers":[{"byteLength":-1}]})",
                           R"("buffers":[{"byteLength":1.5,"uri":"data:;base64,AA=="}]})",
                           R"("buffers":[{"byteLength":9,"uri":"data:;base64,AA=="}]})",
                           R"("buffers":[{"byteLength":1,"uri":"data:;base64,A!"}]})",
                           R"("buffers":[{"byteLength":1,"uri":7}]})",
                           R"("buffers":[{"byteLength":1,"uri":"../x.bin"}]})",
                           R"("meshes":[{}]})",
                           R"("nodes":[1]})",
                           R"("meshes":[{"primitives":{}}]})",
                           R"("meshes":[{"primitives":[{}]}]})",
                           R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}]})",
                           R"("meshes":[{"primitives":[{"attributes":{"POSITION":-1}}]}],"accessors":[{}]})",
                           R"("meshes":[{"primitives":[{"attributes":{},"indices":1}]}],"accessors":[{}]})",
                           R"("meshes":[{"primitives":[{"attributes":{},"targets":[1]}]}]})",
                           R"("meshes":[{"primitives":[{"attributes":{},"targets":[{"POSITION":5}]}]}]})",
                           R"("meshes":[{"primitives":[{"attributes":{},"extensions":[]}]}]})",
                           R"("extensionsUsed":{}})",
                           R"("extensionsUsed":[1]})"}) {
    EXPECT_EQ(load_error(asset + rest).code, ErrorCode::kInvalidFile) << rest;
  }
  for (const char* text : {"[]", "{}", R"({"asset":{"version":"1.0"}})", R"({"asset":{"version":2}})", "7"})
    EXPECT_EQ(load_error(text).code, ErrorCode::kInvalidFile) << text;
}

TEST(References, RefusesMalformedSkinsAndAnimations) {
  for (const char* text :
       {R"({"skins":[{"inverseBindMatrices":3}]})", R"({"skins":"none"})",
        R"({"animations":[{"samplers":[{"input":0}]}]})", R"({"animations":[{"samplers":[1]}]})"})
    EXPECT_FALSE(check_other_accessors(Json::parse(text))) << text;
  EXPECT_TRUE(
      check_other_accessors(Json::parse(R"({"skins":[{"inverseBindMatrices":0}],"accessors":[{}]})")));
}

TEST(Document, AsksForExternalBuffersOnce) {
  GltfBuilder builder;
  builder.sheet_mesh(test::make_sheet(3));
  const Bytes text = builder.gltf("my%20buffer.bin");
  EXPECT_EQ(load_document(text, {}).error().code, ErrorCode::kFileOpen);

  std::vector<std::string> asked;
  Resolver resolve = [&](std::string_view uri) -> Result<std::vector<std::byte>> {
    asked.emplace_back(uri);
    return builder.bin;
  };
  const auto document = load_document(text, resolve);
  ASSERT_TRUE(document);
  EXPECT_EQ(asked, std::vector<std::string>{"my buffer.bin"});
  EXPECT_EQ(document->input_bytes, text.size() + builder.bin.size());

  const std::string twice = R"({"asset":{"version":"2.0"},"buffers":[{"uri":"a.bin","byteLength":2},)"
                            R"({"uri":"a.bin","byteLength":3}]})";
  const auto shared = load_document(std::as_bytes(std::span(twice)), resolve);
  ASSERT_TRUE(shared);
  EXPECT_EQ(asked, (std::vector<std::string>{"my buffer.bin", "a.bin"}));
  EXPECT_EQ(shared->buffers[1].bytes.data(), shared->buffers[0].bytes.data());
  EXPECT_EQ(shared->buffers[1].bytes.size(), 3U);

  resolve = [](std::string_view) -> Result<std::vector<std::byte>> { return Bytes(3); };
  EXPECT_EQ(load_document(text, resolve).error().code, ErrorCode::kInvalidFile);
}

}  // namespace
}  // namespace deltamesh::gltf
