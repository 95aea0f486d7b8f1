// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <numeric>
#include <set>
#include <vector>

#include "field/cube_cases.h"
#include "field/marching_cubes.h"
#include "point.h"
#include "random.h"

namespace deltamesh {
namespace {

using Corner = std::array<float, 3>;

Corner position(const Mesh& mesh, std::uint32_t vertex) {
  Corner p{};
  std::memcpy(p.data(), &mesh.positions[3 * std::size_t{vertex}], sizeof p);
  return p;
}

/// Triangle counts of undirected edges.
std::map<std::array<std::uint32_t, 2>, int> edges_of(const std::vector<std::uint32_t>& triangles) {
  std::map<std::array<std::uint32_t, 2>, int> edges;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::uint32_t a = triangles[i];
    const std::uint32_t b = triangles[i % 3 == 2 ? i - 2 : i + 1];
    ++edges[{std::min(a, b), std::max(a, b)}];
  }
  return edges;
}

struct Topology {
  std::size_t edges = 0;
  std::size_t boundary = 0;
  std::size_t non_manifold = 0;
  std::size_t components = 0;  ///< isolated vertices included
};

Topology topology_of(std::size_t vertices, const std::vector<std::uint32_t>& triangles) {
  std::vector<std::uint32_t> parent(vertices);
  std::iota(parent.begin(), parent.end(), 0U);
  const auto find = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  Topology topology;
  topology.components = vertices;
  for (const auto& [edge, count] : edges_of(triangles)) {
    ++topology.edges;
    if (count == 1) ++topology.boundary;
    if (count > 2) ++topology.non_manifold;
    const std::uint32_t a = find(edge[0]);
    const std::uint32_t b = find(edge[1]);
    if (a == b) continue;
    parent[a] = b;
    --topology.components;
  }
  return topology;
}

Topology topology_of(const Mesh& mesh) { return topology_of(mesh.vertex_count(), mesh.triangles); }

long euler(const Mesh& mesh) {
  return static_cast<long>(mesh.vertex_count()) - static_cast<long>(topology_of(mesh).edges) +
         static_cast<long>(mesh.triangle_count());
}

double volume(const std::vector<float>& positions, const std::vector<std::uint32_t>& triangles) {
  double sum = 0;
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const float* a = &positions[3 * std::size_t{triangles[i]}];
    const float* b = &positions[3 * std::size_t{triangles[i + 1]}];
    const float* c = &positions[3 * std::size_t{triangles[i + 2]}];
    sum += a[0] * (double{b[1]} * c[2] - double{b[2]} * c[1]) +
           a[1] * (double{b[2]} * c[0] - double{b[0]} * c[2]) +
           a[2] * (double{b[0]} * c[1] - double{b[1]} * c[0]);
  }
  return sum / 6;
}

Mesh make(Scene scene, std::uint64_t vertices, std::uint64_t seed = 1) {
  auto mesh = generate_scene(scene, vertices, seed);
  EXPECT_TRUE(mesh);
  return std::move(*mesh);
}

class EveryScene : public testing::TestWithParam<Scene> {};

TEST_P(EveryScene, IsWholeAndNearTheAskedSize) {
  for (const std::uint64_t target : {12U, 13U, 20U, 100U, 1000U, 5000U, 30000U}) {
    const Mesh mesh = make(GetParam(), target);
    ASSERT_EQ(mesh.positions.size() % 3, 0U);
    ASSERT_EQ(mesh.triangles.size() % 3, 0U);
    EXPECT_GT(mesh.triangle_count(), 0U);
    EXPECT_TRUE(
        std::all_of(mesh.positions.begin(), mesh.positions.end(), [](float x) { return std::isfinite(x); }));
    EXPECT_TRUE(std::all_of(mesh.triangles.begin(), mesh.triangles.end(),
                            [&](std::uint32_t v) { return v < mesh.vertex_count(); }));
    for (const Attribute& a : mesh.attributes)
      EXPECT_EQ(a.values.size(), mesh.vertex_count() * a.components * component_size(a.type));
    if (target < 1000) continue;
    EXPECT_GT(static_cast<double>(mesh.vertex_count()), 0.9 * static_cast<double>(target));
    EXPECT_LT(static_cast<double>(mesh.vertex_count()), 1.1 * static_cast<double>(target));
  }
}

TEST_P(EveryScene, DependsOnItsArgumentsOnly) {
  const Mesh a = make(GetParam(), 3000, 5);
  const Mesh b = make(GetParam(), 3000, 5);
  const Mesh c = make(GetParam(), 3000, 6);
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.origin, b.origin);
  ASSERT_EQ(a.attributes.size(), b.attributes.size());
  for (std::size_t i = 0; i < a.attributes.size(); ++i)
    EXPECT_EQ(a.attributes[i].values, b.attributes[i].values);
  EXPECT_NE(a.positions, c.positions);
}

/// FNV-1a over the bytes of positions and triangles.
std::uint64_t hash_of(const Mesh& mesh) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const auto bytes :
       {std::as_bytes(std::span(mesh.positions)), std::as_bytes(std::span(mesh.triangles))})
    for (const std::byte b : bytes) hash = (hash ^ std::to_integer<std::uint64_t>(b)) * 0x100000001b3U;
  return hash;
}

TEST_P(EveryScene, IsTheSameWithEveryCompiler) {
  constexpr std::array<std::uint64_t, 6> kHashes = {3064001821550567865U, 2540294427277669394U,
                                                    1089253716447485024U, 2580713420303679190U,
                                                    5662337229733846722U, 743044558889420569U};
  EXPECT_EQ(hash_of(make(GetParam(), 2000)), kHashes[static_cast<std::size_t>(GetParam())]);
}

TEST_P(EveryScene, HasANameThatFindsIt) {
  const SceneName& entry = scene_names()[static_cast<std::size_t>(GetParam())];
  EXPECT_EQ(entry.scene, GetParam());
  EXPECT_EQ(scene_of_name(entry.name), GetParam());
  EXPECT_FALSE(entry.description.empty());
}

TEST_P(EveryScene, RefusesSizesOutOfRange) {
  EXPECT_EQ(generate_scene(GetParam(), 11, 1).error().code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(generate_scene(GetParam(), 20'000'001, 1).error().code, ErrorCode::kInvalidArgument);
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene,
                         testing::Values(Scene::kRooms, Scene::kTerrain, Scene::kSphere, Scene::kTorus,
                                         Scene::kCad, Scene::kFragments));

TEST(Scenes, UnknownNamesAreNoScenes) {
  EXPECT_FALSE(scene_of_name(""));
  EXPECT_FALSE(scene_of_name("Rooms"));
}

TEST(Circle, IsTheUnitCircle) {
  EXPECT_EQ(scenes::circle(0).cos, 1);
  EXPECT_EQ(scenes::circle(0.25).sin, 1);
  EXPECT_EQ(scenes::circle(-0.5).cos, -1);
  for (double turns = -2; turns < 2; turns += 0.0137) {
    EXPECT_NEAR(scenes::circle(turns).cos, std::cos(2 * scenes::kPi * turns), 1e-14);
    EXPECT_NEAR(scenes::circle(turns).sin, std::sin(2 * scenes::kPi * turns), 1e-14);
  }
}

TEST(SphereScene, IsClosedWithoutHandlesAndFacesOutward) {
  for (const std::uint64_t target : {12U, 50U, 20000U}) {
    const Mesh mesh = make(Scene::kSphere, target);
    const Topology t = topology_of(mesh);
    EXPECT_EQ(euler(mesh), 2);
    EXPECT_EQ(t.boundary + t.non_manifold, 0U);
    EXPECT_EQ(t.components, 1U);
    EXPECT_GT(volume(mesh.positions, mesh.triangles), 0);
  }
}

TEST(TorusScene, IsClosedWithOneHandleAndFacesOutward) {
  for (const std::uint64_t target : {12U, 50U, 20000U}) {
    const Mesh mesh = make(Scene::kTorus, target);
    const Topology t = topology_of(mesh);
    EXPECT_EQ(euler(mesh), 0);
    EXPECT_EQ(t.boundary + t.non_manifold, 0U);
    EXPECT_EQ(t.components, 1U);
    EXPECT_GT(volume(mesh.positions, mesh.triangles), 0);
  }
}

TEST(TerrainScene, IsAGridFarFromTheOrigin) {
  const Mesh mesh = make(Scene::kTerrain, 10000);
  EXPECT_GE(mesh.origin[0], 500000);
  EXPECT_GE(mesh.origin[1], 5000000);
  EXPECT_EQ(euler(mesh), 1);
  EXPECT_EQ(topology_of(mesh).components, 1U);
  EXPECT_EQ(position(mesh, 1)[0] - position(mesh, 0)[0], 2);
  float low = 1e9F;
  float high = -1e9F;
  for (std::size_t i = 2; i < mesh.positions.size(); i += 3) {
    low = std::min(low, mesh.positions[i]);
    high = std::max(high, mesh.positions[i]);
  }
  EXPECT_GT(high - low, 20);
}

TEST(CadScene, IsClosedOnceWeldedAndHasSeams) {
  const Mesh mesh = make(Scene::kCad, 4000);
  ASSERT_EQ(mesh.attributes.size(), 2U);
  EXPECT_EQ(mesh.attributes[0].kind, AttributeKind::kNormal);
  EXPECT_EQ(mesh.attributes[1].kind, AttributeKind::kUv);
  std::map<Corner, std::uint32_t> places;
  std::vector<std::uint32_t> welded;
  for (const std::uint32_t v : mesh.triangles)
    welded.push_back(
        places.try_emplace(position(mesh, v), static_cast<std::uint32_t>(places.size())).first->second);
  EXPECT_LT(places.size(), mesh.vertex_count() * 2 / 3);
  const Topology t = topology_of(places.size(), welded);
  EXPECT_EQ(t.boundary + t.non_manifold, 0U);
  EXPECT_GT(t.components, 10U);
  EXPECT_GT(volume(mesh.positions, mesh.triangles), 0);
}

TEST(CadScene, NormalsAreThoseOfTheirFaces) {
  const Mesh mesh = make(Scene::kCad, 2000);
  std::vector<float> normals(mesh.positions.size());
  std::memcpy(normals.data(), mesh.attributes[0].values.data(), mesh.attributes[0].values.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    const Corner a = position(mesh, mesh.triangles[i]);
    const Corner b = position(mesh, mesh.triangles[i + 1]);
    const Corner c = position(mesh, mesh.triangles[i + 2]);
    const float* n = &normals[3 * std::size_t{mesh.triangles[i]}];
    const double along = n[0] * ((b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1])) +
                         n[1] * ((b[2] - a[2]) * (c[0] - a[0]) - (b[0] - a[0]) * (c[2] - a[2])) +
                         n[2] * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
    EXPECT_GT(along, 0) << i;
    EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-6);
  }
}

TEST(FragmentsScene, HasEveryAwkwardKind) {
  const Mesh mesh = make(Scene::kFragments, 20000);
  EXPECT_EQ(mesh.vertex_count(), 20000U);
  const Topology t = topology_of(mesh);
  EXPECT_GT(t.components, 1500U);
  EXPECT_GT(t.non_manifold, 20U);
  std::set<std::uint32_t> used(mesh.triangles.begin(), mesh.triangles.end());
  EXPECT_LT(used.size(), mesh.vertex_count());
  std::set<std::array<std::uint32_t, 3>> faces;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    std::array<std::uint32_t, 3> face{mesh.triangles[i], mesh.triangles[i + 1], mesh.triangles[i + 2]};
    std::sort(face.begin(), face.end());
    faces.insert(face);
  }
  EXPECT_LT(faces.size() + 50, mesh.triangle_count());
}

TEST(RoomsScene, IsOpenFragmentedAndWithoutCracks) {
  const Mesh mesh = make(Scene::kRooms, 60000);
  const Topology t = topology_of(mesh);
  EXPECT_EQ(t.non_manifold, 0U);
  EXPECT_GT(t.boundary, t.edges / 100);
  EXPECT_LT(t.boundary, t.edges / 10);
  EXPECT_GT(t.components, 10U);
  ASSERT_EQ(mesh.attributes.size(), 1U);
  EXPECT_EQ(mesh.attributes[0].kind, AttributeKind::kColor);
  std::set<std::byte> values(mesh.attributes[0].values.begin(), mesh.attributes[0].values.end());
  EXPECT_GT(values.size(), 100U);
}

TEST(RoomsScene, VerticesLieOnVoxelEdges) {
  const Mesh mesh = make(Scene::kRooms, 5000);
  // Coordinates on the lattice recur; at least two of every vertex's three do.
  std::array<std::map<float, int>, 3> counts;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) ++counts[i % 3][mesh.positions[i]];
  for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
    int recurring = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (counts[axis][mesh.positions[i + axis]] > 1) ++recurring;
    EXPECT_GE(recurring, 2);
  }
}

bool is_inside(unsigned mask, unsigned corner) { return (mask >> corner & 1) != 0; }

TEST(CubeCases, EveryCutEdgeIsUsedAndNoOther) {
  for (unsigned mask = 0; mask < 256; ++mask) {
    std::set<std::uint8_t> used;
    for (const auto& triangle : scenes::cube_cases()[mask]) used.insert(triangle.begin(), triangle.end());
    for (std::uint8_t e = 0; e < 12; ++e) {
      const scenes::CubeEdge& edge = scenes::cube_edges()[e];
      const bool cut = is_inside(mask, edge.low) != is_inside(mask, edge.low | 1U << edge.axis);
      EXPECT_EQ(used.count(e) == 1, cut) << mask;
    }
  }
}

TEST(CubeCases, InnerEdgesLieInNoFaceAndOuterEdgesDo) {
  const auto share_face = [](std::uint32_t a, std::uint32_t b) {
    const auto& edges = scenes::cube_edges();
    for (unsigned axis = 0; axis < 3; ++axis)
      if (edges[a].axis != axis && edges[b].axis != axis &&
          (edges[a].low >> axis & 1) == (edges[b].low >> axis & 1))
        return true;
    return false;
  };
  for (unsigned mask = 0; mask < 256; ++mask) {
    std::vector<std::uint32_t> triangles;
    for (const auto& triangle : scenes::cube_cases()[mask])
      triangles.insert(triangles.end(), triangle.begin(), triangle.end());
    for (const auto& [edge, count] : edges_of(triangles)) {
      EXPECT_LE(count, 2) << mask;
      EXPECT_EQ(share_face(edge[0], edge[1]), count == 1) << mask;
    }
  }
}

TEST(MarchCubes, AnyFieldGivesAClosedSurfaceThatFacesOutward) {
  // White noise meets every case and every pair of ambiguous faces.
  scenes::Lattice lattice{{24, 20, 22}, 0.5, {1, 2, 3}};
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    scenes::Random random(seed);
    std::vector<float> layer(lattice.layer_size());
    const auto source = [&](std::uint32_t i) {
      for (std::size_t node = 0; node < layer.size(); ++node) {
        const std::size_t j = node / lattice.nodes[2];
        const std::size_t k = node % lattice.nodes[2];
        const bool rim = i == 0 || i == 23 || j == 0 || j == 19 || k == 0 || k == 21;
        layer[node] = rim ? 1.0F : static_cast<float>(random.between(-1, 1));
      }
      return std::span<const float>(layer);
    };
    const scenes::Surface surface = scenes::march_cubes(lattice, source);
    const Topology t = topology_of(surface.positions.size() / 3, surface.triangles);
    EXPECT_GT(t.edges, 10000U);
    EXPECT_EQ(t.boundary + t.non_manifold, 0U);
    EXPECT_GT(volume(surface.positions, surface.triangles), 0);
  }
}

TEST(MarchCubes, UnobservedCornersLeaveHoles) {
  const scenes::Lattice lattice{{6, 6, 6}, 1, {}};
  std::vector<float> layer(lattice.layer_size());
  const auto source = [&](std::uint32_t i) {
    for (std::size_t node = 0; node < layer.size(); ++node) {
      layer[node] = static_cast<float>(node % 6) - 2.5F;
      if (i == 3 && node / 6 == 3) layer[node] = scenes::kUnobserved;
    }
    return std::span<const float>(layer);
  };
  const scenes::Surface surface = scenes::march_cubes(lattice, source);
  EXPECT_EQ(surface.triangles.size() / 3, 2U * (25 - 4));
  for (std::size_t i = 2; i < surface.positions.size(); i += 3) EXPECT_EQ(surface.positions[i], 2.5F);
}

}  // namespace
}  // namespace deltamesh
