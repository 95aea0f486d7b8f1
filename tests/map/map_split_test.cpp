// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From a mesh to parts and back: no face twice or missing, vertices shared as before.
#include <gtest/gtest.h>

#include "deltamesh/map/join.h"
#include "deltamesh/map/split.h"
#include "map/map_meshes.h"
#include "support/meshes.h"

namespace deltamesh {
namespace {

using test::attributes_of;
using test::face_bits;
using test::random_mesh;
using test::topology_counts;
using test::wavy_sheet;
using test::welded;

MapDescription description_of(const Mesh& mesh, std::uint32_t cell_steps) {
  MapDescription description{.cell_steps = cell_steps, .attributes = attributes_of(mesh)};
  description.lattice.origin = mesh.origin;
  return description;
}

/// Every face, and shared vertices, whatever the parts.
void expect_whole(const Mesh& mesh, const MapDescription& description, const SplitOptions& options) {
  const auto parts = split(mesh, description, options);
  ASSERT_TRUE(parts) << describe(parts.error());
  const auto joined = join(*parts);
  ASSERT_TRUE(joined);
  EXPECT_EQ(face_bits(*joined), face_bits(mesh));
  // Vertices with equal positions and other attributes stay apart, so compare without.
  EXPECT_EQ(topology_counts(welded(*joined)), topology_counts(welded(mesh)));
  for (std::size_t i = 1; i < parts->size(); ++i) EXPECT_LT((*parts)[i - 1].key, (*parts)[i].key);
}

TEST(MapSplit, MAP4EveryFaceOnceAndSharedVerticesStayShared) {
  for (const std::uint32_t cell_steps : {37U, 200U, 5000U})
    for (const std::uint32_t most : {1U, 50U, 100000U}) {
      expect_whole(wavy_sheet(40, 30, 1, 0), description_of(wavy_sheet(1, 1, 1, 0), cell_steps), {most, 6});
      expect_whole(random_mesh(2, 90, 400), description_of(Mesh(), cell_steps), {most, 6});
    }
}

TEST(MapSplit, AwkwardMeshes) {
  for (const auto& [name, mesh] : test::awkward_meshes()) {
    SCOPED_TRACE(name);
    MapDescription description = description_of(mesh, 512);
    if (!split(mesh, description)) continue;  // beyond the lattice, or no mesh
    expect_whole(mesh, description, {.most_triangles = 10});
  }
}

TEST(MapSplit, MAP4CentroidsInExactArithmetic) {
  // The corners' sum is one step below, at, and above three times the cell's border.
  for (const int off : {-1, 0, 1}) {
    Mesh mesh;
    mesh.positions = {8.0F + static_cast<float>(off), 0, 0, 8, 1, 0, 8, 0, 1};
    mesh.triangles = {0, 1, 2};
    MapDescription description{.cell_steps = 8};
    description.lattice.step_exponent = 0;
    const auto parts = split(mesh, description, {.most_triangles = 1, .most_level = 0});
    ASSERT_TRUE(parts);
    ASSERT_EQ(parts->size(), 1U);
    EXPECT_EQ(parts->front().key, (PartKey{0, off < 0 ? 0 : 1, 0, 0}));
    description.cell_origin = {1, -9, 0};
    EXPECT_EQ(split(mesh, description, {.most_triangles = 1, .most_level = 0})->front().key,
              (PartKey{0, 0, 1, 0}));
  }
}

TEST(MapSplit, MAP8BorderVerticesAreThoseOfSeveralParts) {
  const Mesh mesh = wavy_sheet(20, 20, 3, 0);
  const MapDescription description = description_of(mesh, 200);
  const auto parts = split(mesh, description, {.most_triangles = 1, .most_level = 0});
  ASSERT_TRUE(parts);
  ASSERT_GT(parts->size(), 2U);
  std::map<std::array<std::uint32_t, 3>, int> uses;
  const auto bits = [](const MapPart& part, std::size_t v) {
    std::array<std::uint32_t, 3> b{};
    for (std::size_t k = 0; k < 3; ++k) b[k] = std::bit_cast<std::uint32_t>(part.mesh.positions[3 * v + k]);
    return b;
  };
  for (const MapPart& part : *parts)
    for (std::size_t v = 0; v < part.mesh.vertex_count(); ++v) ++uses[bits(part, v)];
  for (const MapPart& part : *parts) {
    std::size_t next = 0;
    for (std::size_t v = 0; v < part.mesh.vertex_count(); ++v) {
      const bool is_border = next < part.border.size() && part.border[next].vertex == v;
      EXPECT_EQ(is_border, uses[bits(part, v)] > 1);
      if (!is_border) continue;
      const float* p = part.mesh.positions.data() + 3 * v;
      EXPECT_EQ(part.border[next].point, description.lattice.nearest({p[0], p[1], p[2]}));
      ++next;
    }
    EXPECT_EQ(next, part.border.size());
  }
}

TEST(MapSplit, RefusesWhatIsNoMeshOfTheMap) {
  Mesh mesh = wavy_sheet(2, 2, 1, 0);
  MapDescription description = description_of(mesh, 100);
  description.attributes.clear();
  EXPECT_EQ(split(mesh, description).error().code, ErrorCode::kInvalidMesh);
  description = description_of(mesh, 100);
  mesh.positions[3 * 2] = 20000;  // 2^24 steps of 2^-10 are 16384
  const auto beyond = split(mesh, description);
  EXPECT_EQ(beyond.error().code, ErrorCode::kUnmetRequest);
  EXPECT_EQ(beyond.error().where, 2U) << "of the source, whose vertices faces use in another order";
  mesh.positions[3 * 2] = 0;
  EXPECT_EQ(split(mesh, description, {.most_triangles = 0}).error().code, ErrorCode::kInvalidArgument);
  EXPECT_TRUE(split(Mesh(), description_of(Mesh(), 100))->empty());
}

}  // namespace
}  // namespace deltamesh
