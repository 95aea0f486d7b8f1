// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "attributes/normals/lattice.h"
#include "attributes/surface_order.h"
#include "attributes/tangents/rule.h"
#include "attributes/tangents/tangents.h"
#include "base/numbers/portable_math.h"
#include "support/attribute_of.h"
#include "support/soups.h"

namespace deltamesh::surface_tangents_test {
namespace {

/// A surface with everything that tangents are predicted from.
struct Surfaced {
  std::vector<std::uint32_t> triangles;
  std::vector<float> positions;
  std::vector<std::uint32_t> geometric;
  std::vector<float> tangents;
  TangentBasis basis;

  std::uint32_t count() const { return static_cast<std::uint32_t>(tangents.size() / 4); }
  AttributeSurface surface() const { return {triangles, count(), geometric, positions}; }
  void add(const Vec3& p, const Vec3& n, double u, double v, const Vec3& t, float sign) {
    for (const double x : p) positions.push_back(static_cast<float>(x));
    for (const double x : n) basis.normals.push_back(static_cast<float>(x));
    for (const double x : {u, v}) basis.uvs.push_back(static_cast<float>(x));
    for (const double x : t) tangents.push_back(static_cast<float>(x));
    tangents.push_back(sign);
  }
};

constexpr std::uint32_t kSide = 24;

double noise(std::uint32_t i) { return static_cast<double>(i * 2654435761U) / 4294967296.0 - 0.5; }

/// Part of a cylinder whose texture runs around it; `mirror`: 1, or -1 where u grows the other way.
Surfaced cylinder(double mirror) {
  Surfaced mesh;
  mesh.triangles = test::grid(kSide - 1, kSide - 1, false, false, 0, 3).triangles;
  for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
    const double s = (i % kSide + 0.3 * noise(i)) / kSide;
    const double t = (i / kSide + 0.3 * noise(i + 7919)) / kSide;  // NOLINT(bugprone-integer-division)
    const Vec3 normal{std::cos(2 * s), std::sin(2 * s), 0};
    mesh.add({normal[0], normal[1], t}, normal, mirror * 0.4 * s, 0.2 * t,
             {-mirror * std::sin(2 * s), mirror * std::cos(2 * s), 0}, mirror > 0 ? 1.0F : -1.0F);
  }
  return mesh;
}

double largest_angle(const std::vector<float>& a, const std::vector<float>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); i += 4)
    most = std::fmax(most, portable_degrees_between({a[i], a[i + 1], a[i + 2]}, {b[i], b[i + 1], b[i + 2]}));
  return most;
}

/// Coded, read back and compared; the size in bytes.
std::size_t code(const Surfaced& mesh, double bound) {
  const AttributeSurface surface = mesh.surface();
  const auto coded = write_surface_tangents(mesh.tangents, bound, surface, mesh.basis);
  EXPECT_TRUE(coded);
  if (!coded) return 0;
  const auto read = read_surface_tangents(coded->bytes, surface, mesh.basis);
  EXPECT_TRUE(read) << (read ? "" : describe(read.error()));
  if (!read) return 0;
  EXPECT_EQ(*read, coded->values);
  EXPECT_EQ(read->size(), mesh.tangents.size());
  EXPECT_LE(largest_angle(mesh.tangents, *read), bound);
  for (std::size_t i = 3; i < read->size(); i += 4) EXPECT_EQ((*read)[i], mesh.tangents[i]);
  EXPECT_EQ(write_surface_tangents(mesh.tangents, bound, surface, mesh.basis)->bytes, coded->bytes);
  return coded->bytes.size();
}

TEST(SurfaceTangents, ATTR38StepOutOfRangeIsRefused) {
  const Surfaced mesh = cylinder(1);
  const auto coded = write_surface_tangents(mesh.tangents, 0.1, mesh.surface(), mesh.basis);
  ASSERT_TRUE(coded);
  for (const float step : {0.0F, -1.0F, 0x1p-21F, 1.5F, std::numeric_limits<float>::quiet_NaN()}) {
    auto bytes = coded->bytes;
    const auto bits = std::bit_cast<std::uint32_t>(step);
    for (std::size_t k = 0; k < 4; ++k) bytes[k] = static_cast<std::byte>(bits >> (8 * k));
    const auto read = read_surface_tangents(bytes, mesh.surface(), mesh.basis);
    ASSERT_FALSE(read) << step;
    EXPECT_STREQ(read.error().rule, "ATTR-38");
  }
}

TEST(SurfaceTangents, ATTR39BasisIsTheFirstOfItsShape) {
  const auto attribute = [](AttributeKind kind, std::uint8_t components, float value) {
    const std::vector<float> values(std::size_t{2} * components, value);
    return test::attribute_of(kind, ComponentType::kF32, components, "", values);
  };
  const std::vector<Attribute> decoded = {
      attribute(AttributeKind::kUv, 3, 1), attribute(AttributeKind::kUv, 2, 2),
      attribute(AttributeKind::kNormal, 3, 3), attribute(AttributeKind::kUv, 2, 4)};
  const TangentBasis basis = tangent_basis(decoded, 2);
  EXPECT_EQ(basis.uvs, std::vector<float>(4, 2));
  EXPECT_EQ(basis.normals, std::vector<float>(6, 3));
  EXPECT_TRUE(tangent_basis({}, 2).uvs.empty());
}

TEST(TangentRule, ATTR40FollowsTheTexture) {
  for (const double mirror : {1.0, -1.0}) {
    const Surfaced mesh = cylinder(mirror);
    const AttributeSurface surface = mesh.surface();
    const TangentRule rule(surface, mesh.basis.normals, mesh.basis.uvs);
    for (std::uint32_t v = 0; v < mesh.count(); ++v) {
      const RuledTangent ruled = rule.at(v);
      const Vec3 expected{mesh.tangents[4 * v], mesh.tangents[4 * v + 1], mesh.tangents[4 * v + 2]};
      Vec3 direction = widen(ruled.direction);
      EXPECT_GT(normalize(direction), 0);
      EXPECT_LT(portable_degrees_between(direction, expected), 3);
      EXPECT_NEAR(dot(direction, widen(ruled.normal)), 0, 1e-6);
      EXPECT_GT(mirror * ruled.area, 0);
    }
  }
}

TEST(SurfaceTangents, ATTR41WhatTheRuleGivesCostsLittle) {
  const Surfaced mesh = cylinder(1);
  EXPECT_LT(code(mesh, 0.5), mesh.count() / 8);
  Surfaced untold = mesh;
  untold.basis.uvs.clear();
  EXPECT_GT(code(untold, 0.5), code(mesh, 0.5));
  EXPECT_LT(code(cylinder(-1), 0.5), mesh.count() / 8);
}

TEST(SurfaceTangents, ATTR42CopiesThatAreEqualCostNothing) {
  const Surfaced once = cylinder(1);
  Surfaced split;
  for (const std::uint32_t v : once.triangles) {
    split.triangles.push_back(static_cast<std::uint32_t>(split.triangles.size()));
    split.geometric.push_back(v);
    const auto copy = [v](const std::vector<float>& from, std::vector<float>& to, std::uint32_t width) {
      for (std::uint32_t k = 0; k < width; ++k) to.push_back(from[width * v + k]);
    };
    copy(once.positions, split.positions, 3);
    copy(once.basis.normals, split.basis.normals, 3);
    copy(once.tangents, split.tangents, 4);
  }
  const std::size_t known = code(split, 0.05);
  split.geometric.clear();
  EXPECT_LT(2 * known, code(split, 0.05));
}

TEST(SurfaceTangents, ATTR43SignsAreExact) {
  Surfaced mesh = cylinder(1);
  for (std::uint32_t v = 0; v < mesh.count(); v += 3) mesh.tangents[4 * v + 3] = -1;
  code(mesh, 1);
  for (std::uint32_t v = 0; v < mesh.count(); ++v) mesh.tangents[4 * v + 3] = -1;
  // All against the texture: told once, more or less.
  EXPECT_LT(code(mesh, 0.5), mesh.count() / 8);
}

TEST(SurfaceTangents, ATTR44KeepsTheBoundAnywhere) {
  for (const double bound : {0.002, 0.02, 1.0, 20.0, 60.0}) {
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
      const test::Soup soup = test::random_soup(seed, 30, 40);
      Surfaced mesh;
      mesh.triangles = soup.triangles;
      for (std::uint32_t v = 0; v < soup.vertex_count; ++v) {
        Vec3 t{noise(v + 40 * seed), noise(v + 900), noise(v + 77)};
        if (v % 5 == 0) t = {-1, 0, 0};
        normalize(t);
        mesh.add({v % 5 + 0.1 * noise(v), v % 3 == 0 ? 0 : noise(v), seed % 2 == 0 ? 0 : noise(v + 9)},
                 v % 4 == 0 ? Vec3{} : Vec3{0, 0, 1}, v % 6 == 0 ? 0.5 : noise(v + 5),
                 seed % 3 == 0 ? 0 : noise(v + 6), t, v % 2 == 0 ? 1.0F : -1.0F);
        mesh.geometric.push_back(v % 7 == 6 ? v - 1 : v);
      }
      code(mesh, bound);
      mesh.basis.uvs[3] = std::numeric_limits<float>::infinity();
      mesh.basis.normals[3] = std::numeric_limits<float>::quiet_NaN();
      code(mesh, bound);
      mesh.basis.normals.clear();
      code(mesh, bound);
      mesh.positions.clear();
      code(mesh, bound);
      mesh.basis.uvs.clear();
      code(mesh, bound);
    }
  }
}

TEST(SurfaceTangents, ATTR44BrokenStreamsGiveUnitVectorsOrErrors) {
  const Surfaced mesh = cylinder(1);
  const auto bytes = write_surface_tangents(mesh.tangents, 0.01, mesh.surface(), mesh.basis)->bytes;
  std::uint32_t state = 5;
  for (int trial = 0; trial < 300; ++trial) {
    auto broken = bytes;
    for (int flips = 0; flips < 3; ++flips) {
      state = state * 1664525U + 1013904223U;
      broken[4 + (state >> 8) % (broken.size() - 4)] ^= static_cast<std::byte>(1U << (state >> 29));
    }
    const auto read = read_surface_tangents(broken, mesh.surface(), mesh.basis);
    if (!read) continue;
    for (std::size_t i = 0; i < read->size(); i += 4)
      EXPECT_NEAR(length({(*read)[i], (*read)[i + 1], (*read)[i + 2]}), 1, 1e-5);
  }
  for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 8) {
    const std::vector<std::byte> prefix(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_FALSE(read_surface_tangents(prefix, mesh.surface(), mesh.basis)) << size;
  }
}

TEST(SurfaceTangents, WhatDoesNotSuitIsLeftToOtherCodings) {
  Surfaced mesh = cylinder(1);
  EXPECT_FALSE(write_surface_tangents(mesh.tangents, 0, mesh.surface(), mesh.basis));
  EXPECT_FALSE(write_surface_tangents(mesh.tangents, 61, mesh.surface(), mesh.basis));
  mesh.tangents[3] = 0;
  EXPECT_FALSE(write_surface_tangents(mesh.tangents, 1, mesh.surface(), mesh.basis));
  mesh.tangents[3] = 1;
  for (std::size_t i = 0; i < 3; ++i) mesh.tangents[i] = 0;
  EXPECT_FALSE(write_surface_tangents(mesh.tangents, 1, mesh.surface(), mesh.basis));
  mesh.tangents[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(write_surface_tangents(mesh.tangents, 1, mesh.surface(), mesh.basis));
}

}  // namespace
}  // namespace deltamesh::surface_tangents_test
