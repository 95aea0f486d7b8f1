// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What becomes of a primitive's triangles and vertices on their way into a stream: strips and fans, equal
// vertices, triangles that draw nothing.
#include <gtest/gtest.h>

#include <utility>

#include "asset_compare.h"
#include "deltamesh/gltf.h"
#include "gltf_packing.h"
#include "support/gltf_asset.h"

namespace deltamesh {
namespace {

using test::Bytes;
using test::expect_no_cracks;
using test::expect_same_soups;
using test::GltfBuilder;
using test::Json;
using test::lossless;
using test::make_sheet;
using test::OpenedGlb;
using test::pack_ok;
using test::Sheet;
using test::unpack_ok;
using test::with_ids;

TEST(GltfTriangles, BothZerosAreOnePlace) {
  GltfBuilder builder;
  Sheet sheet = make_sheet(9);
  builder.sheet_mesh(sheet);
  for (std::size_t i = 0; i < sheet.positions.size(); i += 3) sheet.positions[i] *= -1;  // borders at -0
  for (std::size_t i = 0; i < sheet.triangles.size(); i += 3)
    std::swap(sheet.triangles[i + 1], sheet.triangles[i + 2]);
  const std::size_t mirrored = builder.sheet_mesh(sheet);
  builder.json["meshes"][0]["primitives"].push_back(builder.json["meshes"][mirrored]["primitives"][0]);
  builder.json["meshes"].erase(mirrored);
  builder.json["nodes"].erase(mirrored);
  const Bytes asset = with_ids(OpenedGlb(builder.glb()));
  GltfPackOptions options;
  options.encode.geometry = GeometryCoder::kHighpass;
  options.encode.bits = 5;
  expect_no_cracks(OpenedGlb(asset), OpenedGlb(unpack_ok(pack_ok(asset, options).asset).asset));
}

TEST(GltfTriangles, StripsAndFansBecomeLists) {
  GltfBuilder builder;
  const Sheet sheet = make_sheet(4);
  Json attributes{{"POSITION", builder.floats(sheet.positions, 3, true)}};
  const std::vector<std::uint32_t> strip{0, 4, 1, 5, 2, 6, 6};  // the last triangle draws nothing
  const std::vector<std::uint32_t> fan{10, 11, 15, 14, 13};
  Json primitives = Json::array();
  primitives.push_back({{"attributes", attributes}, {"indices", builder.indices(strip)}, {"mode", 5}});
  primitives.push_back({{"attributes", attributes}, {"indices", builder.indices(fan)}, {"mode", 6}});
  builder.push("meshes", {{"primitives", primitives}});
  const GltfOutput packed = pack_ok(builder.glb(), lossless());
  EXPECT_EQ(packed.report.converted, 2U);
  const OpenedGlb plain(unpack_ok(packed.asset).asset);
  EXPECT_EQ(plain.primitive(0, 0)["mode"], 4);
  builder.json["meshes"][0]["primitives"][0].erase("mode");
  builder.json["meshes"][0]["primitives"][1].erase("mode");
  builder.json["meshes"][0]["primitives"][0]["indices"] =
      builder.indices({0, 4, 1, 4, 5, 1, 1, 5, 2, 5, 6, 2, 2, 6, 6});
  builder.json["meshes"][0]["primitives"][1]["indices"] =
      builder.indices({11, 15, 10, 15, 14, 10, 14, 13, 10});
  expect_same_soups(OpenedGlb(builder.glb()), plain);
}

TEST(GltfTriangles, UnindexedTrianglesAreWelded) {
  GltfBuilder builder;
  const Sheet sheet = make_sheet(6);
  std::vector<float> positions;
  std::vector<float> uvs;
  for (const std::uint32_t corner : sheet.triangles) {
    positions.insert(positions.end(), &sheet.positions[corner * 3], &sheet.positions[corner * 3] + 3);
    uvs.insert(uvs.end(), &sheet.uvs[corner * 2], &sheet.uvs[corner * 2] + 2);
  }
  uvs[1] += 1;  // one corner differs
  const Json primitive{
      {"attributes",
       {{"POSITION", builder.floats(positions, 3, true)}, {"TEXCOORD_0", builder.floats(uvs, 2)}}}};
  builder.push("meshes", {{"primitives", Json::array({primitive})}});
  const GltfOutput packed = pack_ok(builder.glb(), lossless());
  EXPECT_EQ(packed.report.vertices, 36U);  // of 150: the corner at the sheet's own corner has no partner
  EXPECT_EQ(packed.report.welded_vertices, 150U - 36U);
  expect_same_soups(OpenedGlb(builder.glb()), OpenedGlb(unpack_ok(packed.asset).asset));
  GltfPackOptions ordered;
  ordered.encode.keep_order = true;
  EXPECT_EQ(pack_ok(builder.glb(), ordered).report.vertices, 150U);
}

/// A sheet with a triangle between two copies of one vertex, which differ in their texture coordinates and,
/// where `moves`, in a morph target.
GltfBuilder sheet_with_sliver(bool moves) {
  GltfBuilder builder;
  Sheet sheet = make_sheet(4);
  sheet.positions.insert(sheet.positions.end(), sheet.positions.begin(), sheet.positions.begin() + 3);
  sheet.uvs.insert(sheet.uvs.end(), {5, 5});
  sheet.triangles.insert(sheet.triangles.end(), {0, 1, 16});
  Json primitive{{"attributes",
                  {{"POSITION", builder.floats(sheet.positions, 3, true)},
                   {"TEXCOORD_0", builder.floats(sheet.uvs, 2)}}},
                 {"indices", builder.indices(sheet.triangles)}};
  if (moves) {
    std::vector<float> displacements(sheet.positions.size());
    displacements.back() = 1;
    primitive["targets"] = Json::array({Json{{"POSITION", builder.floats(displacements, 3, true)}}});
  }
  builder.push("meshes", {{"primitives", Json::array({primitive})}});
  return builder;
}

TEST(GltfTriangles, TrianglesThatDrawNothingAreDropped) {
  const GltfReport dropped = pack_ok(sheet_with_sliver(false).glb(), {}).report;
  EXPECT_EQ(dropped.triangles, 18U);
  EXPECT_EQ(dropped.degenerate_triangles, 1U);
  EXPECT_EQ(dropped.unreferenced_vertices, 1U);
  EXPECT_EQ(pack_ok(sheet_with_sliver(true).glb(), {}).report.triangles, 19U);
  EXPECT_EQ(pack_ok(sheet_with_sliver(false).glb(), lossless()).report.triangles, 19U);
  GltfPackOptions ordered;
  ordered.encode.keep_order = true;
  EXPECT_EQ(pack_ok(sheet_with_sliver(false).glb(), ordered).report.triangles, 19U);
}

TEST(GltfTriangles, PrimitiveOfDegenerateTrianglesAloneKeepsThem) {
  GltfBuilder builder;
  const Json primitive{{"attributes", {{"POSITION", builder.floats({0, 0, 0, 0, 0, 0, 1, 0, 0}, 3, true)}}},
                       {"indices", builder.indices({0, 1, 2})}};
  builder.push("meshes", {{"primitives", Json::array({primitive})}});
  const GltfReport report = pack_ok(builder.glb(), test::with_fallback()).report;
  EXPECT_EQ(report.triangles, 1U);
  EXPECT_EQ(report.degenerate_triangles, 0U);
}

}  // namespace
}  // namespace deltamesh
