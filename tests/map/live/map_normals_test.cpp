// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Smooth normals across the borders of parts.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

#include "deltamesh/map/map_codec.h"
#include "deltamesh/map/smooth_normals.h"
#include "deltamesh/map/split.h"
#include "map/map_meshes.h"

namespace deltamesh {
namespace {

std::vector<MapPart> decoded_parts() {
  const Mesh mesh = test::wavy_sheet(30, 30, 5, 0);
  MapDescription description{.cell_steps = 100, .attributes = test::attributes_of(mesh)};
  const auto parts = split(mesh, description, {.most_triangles = 200, .most_level = 4});
  const auto codec = MapCodec::open(description);
  std::vector<MapPart> decoded;
  for (const MapPart& part : *parts) {
    const auto coded = codec->encode(part, {.bounds = {.max_error = QualityBound{0.02}}, .effort = 0});
    EXPECT_TRUE(coded);
    decoded.push_back(*codec->decode(part.key, coded->bytes));
  }
  return decoded;
}

TEST(MapNormals, OfAVertexThatPartsShareHaveTheSameBits) {
  const std::vector<MapPart> parts = decoded_parts();
  ASSERT_GT(parts.size(), 4U);
  std::vector<const MapPart*> all;
  for (const MapPart& part : parts) all.push_back(&part);
  using Key = std::pair<std::array<std::int32_t, 3>, std::uint32_t>;
  std::map<Key, std::array<float, 3>> seen;
  int shared = 0;
  int alone = 0;
  for (const MapPart& part : parts) {
    std::rotate(all.begin(), all.begin() + 1, all.end());  // in any order
    const auto normals = smooth_normals(part, all);
    const auto own = smooth_normals(part, {});
    ASSERT_TRUE(normals && own);
    ASSERT_EQ(normals->size(), part.mesh.positions.size());
    for (std::size_t i = 0; i < normals->size(); i += 3) {
      const float* n = normals->data() + i;
      EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1, 1e-6);
    }
    for (const BorderVertex& vertex : part.border) {
      const float* n = normals->data() + 3 * std::size_t{vertex.vertex};
      const std::array<float, 3> normal{n[0], n[1], n[2]};
      const auto [place, is_first] =
          seen.try_emplace({{vertex.point[0], vertex.point[1], vertex.point[2]}, vertex.twin}, normal);
      if (!is_first) ++shared;
      EXPECT_EQ(place->second, normal);
      if (!std::equal(n, n + 3, own->data() + 3 * std::size_t{vertex.vertex})) ++alone;
    }
  }
  EXPECT_GT(shared, 50);
  EXPECT_GT(alone, 50);  // without its neighbours a part has others
}

TEST(MapNormals, WithoutFacesOrWithBrokenOnes) {
  MapPart part;
  part.mesh.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  EXPECT_EQ(*smooth_normals(part, {}), (std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}));
  part.mesh.triangles = {0, 2, 1};
  EXPECT_EQ(*smooth_normals(part, {}), (std::vector<float>{0, 0, -1, 0, 0, -1, 0, 0, -1}));
  part.mesh.triangles = {0, 2, 3};
  EXPECT_FALSE(smooth_normals(part, {}));
}

}  // namespace
}  // namespace deltamesh
