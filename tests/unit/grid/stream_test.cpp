// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Whole streams of meshes in the cubes of a grid, or not quite: what comes out is what went in.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "deltamesh/compare.h"
#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "scenes.h"
#include "support/meshes.h"
#include "support/random.h"

namespace deltamesh::grid_stream_test {
namespace {

Mesh rooms(std::uint64_t vertices, std::uint64_t seed = 5) {
  Mesh mesh = *generate_scene(Scene::kRooms, vertices, seed);
  for (std::size_t f = 0; f < mesh.triangle_count(); ++f)
    mesh.face_groups.push_back(static_cast<std::uint32_t>(f / 500 % 3));
  return mesh;
}

/// Adds `other`, whose attributes are those of `mesh`, at `offset`.
void add(Mesh& mesh, const Mesh& other, float scale, float offset) {
  const auto first = static_cast<std::uint32_t>(mesh.vertex_count());
  for (const float x : other.positions) mesh.positions.push_back(scale * x + offset);
  for (const std::uint32_t v : other.triangles) mesh.triangles.push_back(first + v);
  for (std::size_t i = 0; i < mesh.attributes.size(); ++i) {
    auto& values = mesh.attributes[i].values;
    values.insert(values.end(), other.attributes[i].values.begin(), other.attributes[i].values.end());
  }
  mesh.face_groups.insert(mesh.face_groups.end(), other.face_groups.begin(), other.face_groups.end());
}

/// Calls `change` with the corners of one face in `often`.
void change_faces(Mesh& mesh, std::uint32_t often, const std::function<void(std::uint32_t*)>& change) {
  test::RandomBits random(3);
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
    if (random() % often == 0) change(mesh.triangles.data() + i);
}

void remove_faces(Mesh& mesh, const std::function<bool(std::size_t)>& is_kept) {
  Mesh kept = mesh;
  kept.triangles.clear();
  kept.face_groups.clear();
  for (std::size_t f = 0; f < mesh.triangle_count(); ++f) {
    if (!is_kept(f)) continue;
    kept.triangles.insert(kept.triangles.end(), mesh.triangles.begin() + static_cast<std::ptrdiff_t>(3 * f),
                          mesh.triangles.begin() + static_cast<std::ptrdiff_t>(3 * f + 3));
    kept.face_groups.push_back(mesh.face_groups[f]);
  }
  mesh = kept;
}

void collapse_edges(Mesh& mesh, std::uint32_t often) {
  std::vector<std::uint32_t> becomes(mesh.vertex_count());
  for (std::uint32_t v = 0; v < becomes.size(); ++v) becomes[v] = v;
  change_faces(mesh, often, [&](const std::uint32_t* face) { becomes[face[0]] = becomes[face[1]]; });
  for (std::uint32_t& v : mesh.triangles) v = becomes[v];
  remove_faces(mesh, [&, before = mesh.triangles](std::size_t f) {
    const std::uint32_t* face = before.data() + 3 * f;
    return face[0] != face[1] && face[1] != face[2] && face[2] != face[0];
  });
}

/// Every vertex of one face in `often` gets a copy of its own there, of another colour.
void split_vertices(Mesh& mesh, std::uint32_t often) {
  change_faces(mesh, often, [&](std::uint32_t* face) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t v = face[c];
      face[c] = static_cast<std::uint32_t>(mesh.vertex_count());
      for (std::size_t axis = 0; axis < 3; ++axis)
        mesh.positions.push_back(float{mesh.positions[3 * std::size_t{v} + axis]});
      for (Attribute& attribute : mesh.attributes) {
        const std::size_t bytes = attribute.values.size() / (mesh.vertex_count() - 1);
        for (std::size_t i = 0; i < bytes; ++i)
          attribute.values.push_back(attribute.values[bytes * v + i] ^ std::byte{0x11});
      }
    }
  });
}

struct NamedMesh {
  std::string name;
  Mesh mesh;
  bool is_grid = true;  ///< the grid coder takes the fewest bytes
};

std::vector<NamedMesh> meshes() {
  std::vector<NamedMesh> all;
  const Mesh plain = rooms(6000);
  const auto add_case = [&](const char* name, const std::function<void(Mesh&)>& change, bool is_grid = true) {
    all.push_back({name, plain, is_grid});
    change(all.back().mesh);
  };
  add_case("plain", [](Mesh&) {});
  add_case(
      "half of it from no voxels",
      [](Mesh& mesh) {
        Mesh lumps = rooms(6000);
        test::RandomBits random(9);
        for (float& x : lumps.positions) x += static_cast<float>(random() % 1000) / 20000;
        add(mesh, lumps, 1, 0.4F);
      },
      false);
  add_case(
      "two grids", [](Mesh& mesh) { add(mesh, rooms(4000, 8), 0.737F, 1); }, false);
  add_case("one edge in 1000 collapsed", [](Mesh& mesh) { collapse_edges(mesh, 1000); });
  add_case(
      "one edge in 20 collapsed", [](Mesh& mesh) { collapse_edges(mesh, 20); }, false);
  add_case("one face in 20 missing",
           [](Mesh& mesh) { remove_faces(mesh, [](std::size_t f) { return f % 20 != 7; }); });
  add_case("one face in 10 twice", [](Mesh& mesh) {
    const Mesh before = mesh;
    for (std::size_t f = 0; f < before.triangle_count(); f += 10) {
      for (std::size_t c = 0; c < 3; ++c) mesh.triangles.push_back(before.triangles[3 * f + c]);
      mesh.face_groups.push_back(before.face_groups[f]);
    }
  });
  add_case("one face in 20 flipped", [](Mesh& mesh) {
    change_faces(mesh, 20, [](std::uint32_t* face) { std::swap(face[1], face[2]); });
  });
  add_case("one vertex in 100 moved", [](Mesh& mesh) {
    test::RandomBits random(4);
    for (std::size_t v = 0; v < mesh.vertex_count(); v += 100)
      for (std::size_t axis = 0; axis < 3; ++axis)
        mesh.positions[3 * v + axis] += static_cast<float>(random() % 100) / 2000;
  });
  add_case("vertices split", [](Mesh& mesh) { split_vertices(mesh, 7); });
  return all;
}

bool equal_rows(const std::vector<std::byte>& a, std::size_t i, const std::vector<std::byte>& b,
                std::size_t j, std::size_t bytes) {
  return std::memcmp(a.data() + i * bytes, b.data() + j * bytes, bytes) == 0;
}

/// Every face with its group, by the source's vertices.
std::vector<std::array<std::uint32_t, 4>> faces_of(const Mesh& mesh,
                                                   const std::function<std::uint32_t(std::uint32_t)>& name) {
  std::vector<std::array<std::uint32_t, 4>> faces;
  for (std::size_t f = 0; f < mesh.triangle_count(); ++f) {
    std::array<std::uint32_t, 3> face{};
    for (std::size_t c = 0; c < 3; ++c) face[c] = name(mesh.triangles[3 * f + c]);
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    faces.push_back({face[0], face[1], face[2], mesh.face_groups[f]});
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

void expect_same(const Mesh& source, const Encoded& encoded, const Mesh& decoded) {
  const auto& order = encoded.order;
  ASSERT_EQ(order.size(), decoded.vertex_count());
  EXPECT_EQ(faces_of(decoded, [&](std::uint32_t v) { return order[v]; }),
            faces_of(source, [](std::uint32_t v) { return v; }));
  double largest = 0;
  for (std::size_t v = 0; v < order.size(); ++v) {
    double square = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      square += std::pow(double{decoded.positions[3 * v + axis]} -
                             double{source.positions[3 * std::size_t{order[v]} + axis]},
                         2);
    largest = std::max(largest, std::sqrt(square));
  }
  EXPECT_LE(largest, encoded.report.stream.quality.max_error * (1 + 1e-12));
  ASSERT_EQ(decoded.attributes.size(), source.attributes.size());
  for (std::size_t i = 0; i < source.attributes.size(); ++i) {
    const std::size_t bytes = source.attributes[i].values.size() / source.vertex_count();
    for (std::size_t v = 0; v < order.size(); ++v)
      ASSERT_TRUE(equal_rows(decoded.attributes[i].values, v, source.attributes[i].values, order[v], bytes));
  }
}

TEST(GridStream, GRD12MeshesComeBack) {
  for (const NamedMesh& named : meshes()) {
    for (const int effort : {0, 1}) {
      const auto encoded = encode(named.mesh, {.quality = {.max_error = QualityBound{0.004}},
                                               .effort = effort,
                                               .attributes = {.color_error = 0}});
      ASSERT_TRUE(encoded) << named.name;
      EXPECT_LE(encoded->report.stream.quality.max_error, 0.004) << named.name;
      if (named.is_grid) {
        EXPECT_EQ(encoded->report.stream.geometry, "grid") << named.name;
      }
      const auto decoded = decode(encoded->bytes);
      ASSERT_TRUE(decoded) << named.name << decoded.error().message;
      SCOPED_TRACE(named.name);
      expect_same(named.mesh, *encoded, *decoded);
    }
  }
}

/// On a grid of 0.04 m a bound of 0.002 m takes 10 levels, not 11 as the quotient is rounded up.
TEST(GridStream, ARoundBoundTakesNoLevelMore) {
  const Mesh mesh = rooms(3000);
  for (const int effort : {0, 1}) {
    const auto at = [&](double bound) {
      const auto encoded = encode(mesh, {.quality = {.max_error = QualityBound{bound}}, .effort = effort});
      EXPECT_EQ(encoded->report.stream.geometry, "grid");
      EXPECT_LE(encoded->report.stream.quality.max_error, bound);
      return encoded->report.stream;
    };
    for (const double bound : {0.003, 0.005, 0.01, 0.02, 0.04}) {
      const StreamInfo first = at(bound);
      // Half a level, or what is a little more as some vertex is just between two.
      const double half = std::max(first.step / 2 * (1 - 1e-6), first.quality.max_error);
      EXPECT_EQ(at(half).step, first.step) << bound;
    }
  }
}

TEST(GridStream, TheOrderIsKeptWhereItIsAskedFor) {
  Mesh mesh = rooms(3000);
  split_vertices(mesh, 9);
  mesh.positions.insert(mesh.positions.end(), {1, 2, 3, 4, 5, 6});
  for (Attribute& attribute : mesh.attributes)
    attribute.values.resize(attribute.values.size() +
                            2 * attribute.values.size() / (mesh.vertex_count() - 2));
  const auto encoded = encode(mesh, {.quality = {.max_error = QualityBound{0.004}},
                                     .attributes = {.color_error = 0},
                                     .keep_order = true,
                                     .keep_unreferenced = true});
  ASSERT_TRUE(encoded);
  EXPECT_EQ(encoded->report.stream.geometry, "grid");
  const auto decoded = decode(encoded->bytes);
  ASSERT_TRUE(decoded);
  EXPECT_EQ(decoded->triangles, mesh.triangles);
  EXPECT_EQ(decoded->face_groups, mesh.face_groups);
  for (std::size_t i = 0; i < mesh.attributes.size(); ++i)
    EXPECT_EQ(decoded->attributes[i].values, mesh.attributes[i].values);
}

TEST(GridStream, BoundsAndBytesAreKept) {
  const Mesh mesh = rooms(4000);
  const auto vde = encode(mesh, {.quality = {.vde = QualityBound{0.002}}});
  ASSERT_TRUE(vde);
  EXPECT_LE(vde->report.stream.quality.vde_rms, 0.002);
  const auto lfe = encode(mesh, {.quality = {.lfe = QualityBound{0.002}}});
  ASSERT_TRUE(lfe);
  EXPECT_EQ(lfe->report.stream.geometry, "grid");
  EXPECT_LE(lfe->report.stream.quality.lfe_rms, 0.002);
  EXPECT_GE(lfe->report.stream.quality.lfe_rms, 0.0012);
  Mesh bare = mesh;
  bare.attributes.clear();
  const auto bytes = encode(bare, {.quality = {.target_bytes = 3000}});
  ASSERT_TRUE(bytes) << bytes.error().message;
  EXPECT_LE(bytes->bytes.size(), 3000U);
  EXPECT_GE(bytes->bytes.size(), 2600U);
  EXPECT_EQ(bytes->report.stream.geometry, "grid");
  const auto colored = encode(mesh, {.quality = {.target_bytes = 9000}});
  ASSERT_TRUE(colored) << colored.error().message;
  EXPECT_LE(colored->bytes.size(), 9000U);
  for (const auto* encoded : {&*vde, &*lfe, &*bytes, &*colored}) EXPECT_TRUE(decode(encoded->bytes));
}

TEST(GridStream, ABoxOfCubesIsNotTakenForThatOfTheMesh) {
  const Mesh mesh = rooms(1000);
  const auto encoded = encode(mesh);
  ASSERT_TRUE(encoded);
  ASSERT_EQ(encoded->report.stream.geometry, "grid");
  const auto compared = compare(mesh, *decode(encoded->bytes));
  ASSERT_TRUE(compared);
  EXPECT_NEAR(encoded->report.stream.diagonal, compared->diagonal, 1e-9);
  EXPECT_EQ(encoded->report.stream.extent, encoded->report.stream.diagonal);
  const auto told = inspect(encoded->bytes);
  ASSERT_TRUE(told);
  EXPECT_EQ(told->diagonal, 0);
  EXPECT_LE(told->box_min[0], encoded->report.stream.box_min[0]);
  EXPECT_GE(told->box_max[0], encoded->report.stream.box_max[0]);
}

TEST(GridStream, LimitsAreKept) {
  const Mesh mesh = rooms(2000);
  const auto encoded = encode(mesh, {.quality = {.max_error = QualityBound{0.004}}});
  ASSERT_TRUE(encoded);
  const auto& stream = encoded->report.stream;
  EXPECT_TRUE(
      decode(encoded->bytes, {.limits = {.vertices = stream.vertices, .triangles = stream.triangles}}));
  const auto vertices = decode(encoded->bytes, {.limits = {.vertices = stream.vertices - 1}});
  ASSERT_FALSE(vertices);
  EXPECT_EQ(vertices.error().code, ErrorCode::kLimitExceeded);
  const auto faces = decode(encoded->bytes, {.limits = {.triangles = stream.triangles - 1}});
  ASSERT_FALSE(faces);
  EXPECT_EQ(faces.error().code, ErrorCode::kLimitExceeded);
}

TEST(GridStream, CutAndBrokenStreamsAreRefused) {
  const Mesh mesh = rooms(400);
  const auto encoded = encode(mesh, {.quality = {.max_error = QualityBound{0.02}}});
  ASSERT_TRUE(encoded);
  ASSERT_EQ(encoded->report.stream.geometry, "grid");
  for (std::size_t size = 0; size < encoded->bytes.size(); size += 7)
    EXPECT_FALSE(decode(std::span(encoded->bytes).first(size))) << size;
}

}  // namespace
}  // namespace deltamesh::grid_stream_test
