// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Packing and unpacking from file to file.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "deltamesh/gltf.h"
#include "deltamesh/io.h"
#include "support/gltf_asset.h"

namespace deltamesh::gltf_files_test {
namespace {

using test::GltfBuilder;
using test::Json;
using test::make_sheet;
using test::OpenedGlb;

std::filesystem::path corpus() {
  const char* folder = std::getenv("DELTAMESH_CORPUS");
  return folder ? folder : DELTAMESH_SOURCE_DIR "/../shared/corpus";
}

class GltfFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::path(testing::TempDir()) /
        (std::string("deltamesh_gltf_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_ / "in");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::filesystem::path folder_;
};

TEST_F(GltfFiles, ExternalBuffersAreReadAndWrittenBesideTheAsset) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(8));
  ASSERT_TRUE(write_file(path("in/a.gltf"), builder.gltf("the%20data.bin")));
  ASSERT_TRUE(write_file(path("in/the data.bin"), builder.bin));
  const auto packed = pack_gltf_file(path("in/a.gltf"), path("my packed.gltf"));
  ASSERT_TRUE(packed) << describe(packed.error());
  EXPECT_EQ(packed->converted, 1U);
  ASSERT_TRUE(std::filesystem::exists(path("my packed.bin")));
  const auto text = read_file(path("my packed.gltf"));
  ASSERT_TRUE(text);
  EXPECT_EQ(Json::parse(reinterpret_cast<const char*>(text->data()),
                        reinterpret_cast<const char*>(text->data()) + text->size())["buffers"][0]["uri"],
            "my%20packed.bin");
  ASSERT_TRUE(unpack_gltf_file(path("my packed.gltf"), path("plain.GLB")));
  const auto plain = read_file(path("plain.GLB"));
  ASSERT_TRUE(plain);
  EXPECT_EQ(OpenedGlb(*plain).json["accessors"][0]["count"], 64);
}

TEST_F(GltfFiles, ErrorsLeaveNoFiles) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(4));
  ASSERT_TRUE(write_file(path("in/a.gltf"), builder.gltf("missing.bin")));
  EXPECT_EQ(pack_gltf_file(path("in/a.gltf"), path("out.glb")).error().code, ErrorCode::kFileOpen);
  EXPECT_EQ(pack_gltf_file(path("in/none.glb"), path("out.glb")).error().code, ErrorCode::kFileOpen);
  ASSERT_TRUE(write_file(path("in/a.glb"), builder.glb()));
  EXPECT_EQ(pack_gltf_file(path("in/a.glb"), path("out.ply")).error().code, ErrorCode::kUnknownFormat);
  EXPECT_EQ(pack_gltf_file(path("in/a.glb"), path("out")).error().code, ErrorCode::kUnknownFormat);
  EXPECT_EQ(unpack_gltf_file(path("in/a.glb"), path("nowhere/out.glb")).error().code, ErrorCode::kFileWrite);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(GltfFiles, AResolverThatThrowsIsTheCallersError) {
  GltfBuilder builder;
  builder.sheet_mesh(make_sheet(4));
  GltfIo io;
  io.resolve = [](std::string_view) -> Result<std::vector<std::byte>> { throw 7; };
  const auto packed = pack_gltf(builder.gltf("missing.bin"), {}, io);
  ASSERT_FALSE(packed);
  EXPECT_EQ(packed.error().code, ErrorCode::kInvalidArgument);
}

TEST_F(GltfFiles, AnAssetIsWrittenWithItsBufferOrNotAtAll) {
  GltfBuilder small;
  small.sheet_mesh(make_sheet(4));
  ASSERT_TRUE(write_file(path("in/small.glb"), small.glb()));
  GltfBuilder large;
  large.sheet_mesh(make_sheet(8));
  ASSERT_TRUE(write_file(path("in/large.glb"), large.glb()));
  ASSERT_TRUE(pack_gltf_file(path("in/small.glb"), path("out.gltf")));
  const auto buffer = read_file(path("out.bin"));
  ASSERT_TRUE(buffer);
  std::filesystem::remove(path("out.gltf"));
  std::filesystem::create_symlink("none/out.gltf", path("out.gltf"));  // which cannot be created
  EXPECT_EQ(pack_gltf_file(path("in/large.glb"), path("out.gltf")).error().code, ErrorCode::kFileWrite);
  EXPECT_EQ(*read_file(path("out.bin")), *buffer);
  std::filesystem::remove(path("out.gltf"));
  std::filesystem::remove(path("out.bin"));
  std::filesystem::create_symlink("none/out.bin", path("out.bin"));
  const auto refused = pack_gltf_file(path("in/large.glb"), path("out.gltf"));
  ASSERT_FALSE(refused);
  EXPECT_STREQ(refused.error().found.data(), "out.bin");
  EXPECT_FALSE(std::filesystem::exists(path("out.gltf")));
}

/// Counts of every primitive: vertices and indices.
std::vector<std::pair<std::size_t, std::size_t>> counts_of(const Json& json) {
  std::vector<std::pair<std::size_t, std::size_t>> counts;
  for (const Json& mesh : json["meshes"])
    for (const Json& primitive : mesh["primitives"]) {
      const auto count = [&](const Json& accessor) {
        return json["accessors"][accessor.get<std::size_t>()]["count"].get<std::size_t>();
      };
      counts.emplace_back(count(primitive["attributes"]["POSITION"]), count(primitive["indices"]));
    }
  return counts;
}

TEST_F(GltfFiles, CorpusAssetsComeBackWithTheSameCounts) {
  if (!std::filesystem::exists(corpus() / "formats")) GTEST_SKIP() << "skipped: no corpus";
  for (const char* name : {"Duck.glb", "Lantern.gltf", "boat.glb", "kitchen_tsdf_40mm.glb"}) {
    SCOPED_TRACE(name);
    const std::string in = (corpus() / "formats" / name).string();
    ASSERT_TRUE(unpack_gltf_file(in, path("original.glb")));  // not packed: only made a GLB
    GltfPackOptions options;
    options.encode.keep_unreferenced = true;
    const auto packed = pack_gltf_file(in, path("packed.glb"), options);
    ASSERT_TRUE(packed) << describe(packed.error());
    EXPECT_EQ(packed->converted, packed->primitives);
    EXPECT_LT(packed->output_bytes, packed->input_bytes);
    ASSERT_TRUE(unpack_gltf_file(path("packed.glb"), path("plain.glb")));
    const OpenedGlb original(*read_file(path("original.glb")));
    const OpenedGlb plain(*read_file(path("plain.glb")));
    EXPECT_EQ(counts_of(plain.json), counts_of(original.json));
    for (const char* key : {"materials", "nodes", "scenes", "textures", "samplers", "asset"}) {
      const bool present = original.json.contains(key);
      EXPECT_EQ(plain.json.contains(key), present) << key;
      if (present) {
        EXPECT_EQ(plain.json[key].dump(), original.json[key].dump()) << key;
      }
    }
    RecordProperty(std::string(name), static_cast<int>(packed->output_bytes));
  }
}

/// An asset beside which the image "textures/my image.png" lies.
class GltfImages : public GltfFiles {
 protected:
  void SetUp() override {
    GltfFiles::SetUp();
    std::filesystem::create_directories(folder_ / "in/textures");
    ASSERT_TRUE(write_file(path("in/textures/my image.png"), test::bytes_of(std::string("pixels"))));
    write_asset("textures/my%20image.png");
  }
  void write_asset(const std::string& uri) {
    GltfBuilder builder;
    builder.sheet_mesh(make_sheet(8));
    builder.push("images", {{"uri", uri}});
    builder.push("images", {{"uri", "data:image/png;base64,AA=="}});
    builder.push("images", {{"uri", "https://example.org/a.png"}});
    ASSERT_TRUE(write_file(path("in/a.glb"), builder.glb()));
  }
  Result<GltfReport> pack_to(const std::string& out) const {
    return pack_gltf_file(path("in/a.glb"), path(out));
  }
  std::string text_at(const std::string& name) const {
    const auto bytes = read_file(path(name));
    return bytes ? std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size()) : "none";
  }
};

TEST_F(GltfImages, GoWithTheAssetToAnotherFolder) {
  std::filesystem::create_directories(folder_ / "out");
  const auto packed = pack_to("out/b.glb");
  ASSERT_TRUE(packed) << describe(packed.error());
  EXPECT_EQ(packed->copied_files, 1U);
  EXPECT_EQ(text_at("out/textures/my image.png"), "pixels");
  const auto again = pack_to("out/c.gltf");  // it is there already
  ASSERT_TRUE(again) << describe(again.error());
  EXPECT_EQ(again->copied_files, 0U);
  std::filesystem::create_directories(folder_ / "plain");
  const auto unpacked = unpack_gltf_file(path("out/c.gltf"), path("plain/d.glb"));
  ASSERT_TRUE(unpacked) << describe(unpacked.error());
  EXPECT_EQ(text_at("plain/textures/my image.png"), "pixels");
}

TEST_F(GltfImages, AreNeitherCopiedNorAskedForInTheSameFolder) {
  std::filesystem::remove(path("in/textures/my image.png"));
  const auto packed = pack_to("in/../in/b.glb");
  ASSERT_TRUE(packed) << describe(packed.error());
  EXPECT_EQ(packed->copied_files, 0U);
}

TEST_F(GltfImages, ThatCannotGoWithTheAssetAreErrors) {
  std::filesystem::create_directories(folder_ / "out/textures");
  const auto expect_refused = [&](ErrorCode code) {
    const auto packed = pack_to("out/b.glb");
    ASSERT_FALSE(packed);
    EXPECT_EQ(packed.error().code, code) << packed.error().message;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out/b.glb"));
  };
  ASSERT_TRUE(write_file(path("out/textures/my image.png"), test::bytes_of(std::string("others"))));
  expect_refused(ErrorCode::kFileWrite);
  EXPECT_EQ(text_at("out/textures/my image.png"), "others");
  std::filesystem::remove(path("out/textures/my image.png"));
  std::filesystem::remove(path("in/textures/my image.png"));
  const auto missing = pack_to("c.glb");  // a link that was broken before
  ASSERT_TRUE(missing) << describe(missing.error());
  EXPECT_EQ(missing->missing_files, 1U);
  EXPECT_EQ(missing->copied_files, 0U);
  ASSERT_TRUE(write_file(path("b.png"), test::bytes_of(std::string("pixels"))));
  write_asset("../b.png");
  expect_refused(ErrorCode::kInvalidFile);
  ASSERT_TRUE(write_file(path("in/b.glb"), test::bytes_of(std::string("pixels"))));
  write_asset("b.glb");  // the name of the result
  expect_refused(ErrorCode::kFileWrite);
}

}  // namespace
}  // namespace deltamesh::gltf_files_test
