// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Real assets, packed and unpacked: no cracks, bounds kept, everything else untouched.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>

#include "asset_compare.h"
#include "deltamesh/gltf.h"
#include "deltamesh/io.h"
#include "gltf_packing.h"

namespace deltamesh {
namespace {

using test::Bytes;
using test::distance;
using test::expect_no_cracks;
using test::expect_same_soups;
using test::floats_of;
using test::for_each_vertex;
using test::Json;
using test::OpenedGlb;
using test::pack_ok;
using test::unpack_ok;
using test::with_ids;

std::filesystem::path corpus() {
  const char* folder = std::getenv("DELTAMESH_CORPUS");
  return folder ? folder : DELTAMESH_SOURCE_DIR "/../shared/corpus";
}

class GltfCorpus : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(corpus())) GTEST_SKIP() << "skipped: no corpus";
    const auto file = read_file((corpus() / "gltf" / GetParam()).string());
    ASSERT_TRUE(file);
    asset_ = *file;
  }
  Bytes asset_;
};

/// The asset without numbers of accessors and views.
Json without_numbers(Json json) {
  for (const char* key : {"buffers", "bufferViews", "accessors"}) json.erase(key);
  for (Json& mesh : json["meshes"])
    for (Json& primitive : mesh["primitives"])
      for (const char* key : {"attributes", "indices", "targets"}) primitive.erase(key);
  for (const char* list : {"images", "skins", "animations"})
    if (json.contains(list))
      for (Json& item : json[list]) {
        for (const char* key : {"bufferView", "inverseBindMatrices"}) item.erase(key);
        if (item.contains("samplers"))
          for (Json& sampler : item["samplers"])
            for (const char* key : {"input", "output"}) sampler.erase(key);
      }
  return json;
}

/// Bytes of an accessor that no primitive uses, and its JSON but for places.
std::pair<Bytes, Json> content_of(const OpenedGlb& glb, const Json& number) {
  Json item = glb.json["accessors"][number.get<std::size_t>()];
  Bytes bytes = glb.view(item["bufferView"].get<std::size_t>());
  bytes.erase(bytes.begin(), bytes.begin() + item.value("byteOffset", std::ptrdiff_t{0}));
  item.erase("bufferView");
  item.erase("byteOffset");
  return {bytes, item};
}

void expect_rest_unchanged(const OpenedGlb& before, const OpenedGlb& after) {
  EXPECT_TRUE(without_numbers(before.json).dump() == without_numbers(after.json).dump());
  const auto expect_same = [&](const Json& a, const Json& b) {
    const auto [bytes, item] = content_of(before, a);
    const auto [after_bytes, after_item] = content_of(after, b);
    EXPECT_EQ(item, after_item);
    const std::size_t size = std::min(bytes.size(), after_bytes.size());
    EXPECT_TRUE(
        std::equal(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size), after_bytes.begin()));
  };
  for (std::size_t i = 0; before.json.contains("animations") && i < before.json["animations"].size(); ++i) {
    const Json& samplers = before.json["animations"][i]["samplers"];
    for (std::size_t k = 0; k < samplers.size(); ++k)
      for (const char* key : {"input", "output"})
        expect_same(samplers[k][key], after.json["animations"][i]["samplers"][k][key]);
  }
  for (std::size_t i = 0; before.json.contains("skins") && i < before.json["skins"].size(); ++i)
    expect_same(before.json["skins"][i]["inverseBindMatrices"],
                after.json["skins"][i]["inverseBindMatrices"]);
  for (std::size_t i = 0; before.json.contains("images") && i < before.json["images"].size(); ++i)
    if (before.json["images"][i].contains("bufferView")) {
      EXPECT_EQ(before.view(before.json["images"][i]["bufferView"]),
                after.view(after.json["images"][i]["bufferView"]));
    }
}

TEST_P(GltfCorpus, LosslessBringsEveryTriangleBackToTheLastBit) {
  GltfPackOptions options;
  options.encode.lossless = true;
  options.encode.effort = 0;
  const GltfOutput packed = pack_ok(asset_, options);
  EXPECT_EQ(packed.report.converted + packed.report.not_smaller, packed.report.primitives);
  const OpenedGlb before(asset_);
  const OpenedGlb after(unpack_ok(packed.asset).asset);
  expect_same_soups(before, after);
  expect_rest_unchanged(before, after);
}

TEST_P(GltfCorpus, PrimitivesOfAMeshFitAndBoundsHold) {
  const Bytes asset = with_ids(OpenedGlb(asset_));
  GltfPackOptions options;
  options.encode.effort = 0;
  options.encode.quality.max_error = QualityBound{.value = 0.1, .unit = QualityUnit::kDiagonal};
  options.encode.attributes.weight_error = 0.01;
  const GltfOutput packed = pack_ok(asset, options);
  EXPECT_LE(packed.report.max_error_percent, 0.1);
  const OpenedGlb before(asset);
  const OpenedGlb after(unpack_ok(packed.asset).asset);
  expect_no_cracks(before, after);
  for (std::size_t m = 0; m < before.json["meshes"].size(); ++m) {
    for (std::size_t p = 0; p < before.json["meshes"][m]["primitives"].size(); ++p) {
      std::map<std::string, double> largest;
      for_each_vertex(before, before.primitive(m, p), after, after.primitive(m, p),
                      [&](const std::string& name, const Bytes& from, const Bytes& to) {
                        if (name.starts_with("JOINTS")) {
                          largest[name] = std::max(largest[name], from == to ? 0.0 : 1.0);
                          return;
                        }
                        const auto a = floats_of(from);
                        const auto b = floats_of(to);
                        for (std::size_t k = 0; k < a.size(); ++k)
                          largest[name] = std::max(largest[name], std::abs(double(a[k]) - b[k]));
                      });
      for (const auto& [name, error] : largest) {
        if (name.ends_with("POSITION")) {
          EXPECT_LE(error, packed.report.max_error * 1.0001 + 1e-30) << name;
        } else if (name.starts_with("JOINTS") || name == "_ID") {
          EXPECT_EQ(error, 0) << name;
        } else if (name.starts_with("WEIGHTS")) {
          EXPECT_LE(error, 0.01) << name;
        } else if (name.starts_with("TEXCOORD")) {
          EXPECT_LE(error, 1.0 / 4096) << name;
        } else {
          EXPECT_LE(error, 0.0088) << name;  // half a degree
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Assets, GltfCorpus,
                         testing::Values("2CylinderEngine.glb", "AnimatedMorphSphere.glb",
                                         "ClearCoatTest.glb", "FlightHelmet.glb", "Fox.glb",
                                         "MorphStressTest.glb", "cakeBirthday.glb", "terrain.glb"),
                         [](const auto& asset) {
                           const std::string name = asset.param;
                           return name.substr(0, name.size() - 4);
                         });

}  // namespace
}  // namespace deltamesh
