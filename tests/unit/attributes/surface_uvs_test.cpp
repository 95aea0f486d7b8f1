// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <limits>
#include <vector>

#include "attributes/prediction/blend.h"
#include "attributes/prediction/linear_fit.h"
#include "attributes/surface_order.h"
#include "attributes/uvs/uvs.h"
#include "support/guarded.h"
#include "support/soups.h"

namespace deltamesh::surface_uvs_test {
namespace {

/// A textured surface, and what is asked of it.
struct Textured {
  std::vector<std::uint32_t> triangles;
  std::vector<float> positions;
  std::vector<float> uvs;
  std::vector<std::uint32_t> geometric;

  std::uint32_t count() const { return static_cast<std::uint32_t>(uvs.size() / 2); }
  AttributeSurface surface() const { return {triangles, count(), geometric, positions}; }
  void add(const Vec3& p, double u, double v) {
    for (const double x : p) positions.push_back(static_cast<float>(x));
    uvs.push_back(static_cast<float>(u));
    uvs.push_back(static_cast<float>(v));
  }
};

double noise(std::uint32_t i) { return static_cast<double>(i * 2654435761U) / 4294967296.0 - 0.5; }

/// side x side vertices on a wavy patch; `texture(s, t)` gives the texture coordinates, s and t from 0 to 1.
template <class Texture>
Textured patch(std::uint32_t side, double waves, Texture texture) {
  Textured mesh;
  mesh.triangles = test::grid(side - 1, side - 1, false, false, 0, 3).triangles;
  for (std::uint32_t i = 0; i < side * side; ++i) {
    const double s = (i % side + 0.3 * noise(i)) / side;
    const double t = (i / side + 0.3 * noise(i + 7919)) / side;  // NOLINT(bugprone-integer-division): the row
    const std::array<double, 2> uv = texture(s, t);
    mesh.add({s, 0.6 * t - waves * std::sin(5 * s), 0.8 * t + waves * std::cos(4 * t)}, uv[0], uv[1]);
  }
  return mesh;
}

std::array<double, 2> turned_texture(double s, double t) {
  return {0.1 + 0.3 * s - 0.4 * t, 0.4 * s + 0.3 * t};
}

double largest_error(const std::vector<float>& a, const std::vector<float>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); i += 2)
    most = std::fmax(most, std::hypot(double{a[i]} - double{b[i]}, double{a[i + 1]} - double{b[i + 1]}));
  return most;
}

/// Coded, read back and compared; the size in bytes.
std::size_t code(const Textured& mesh, double bound) {
  const AttributeSurface surface = mesh.surface();
  const auto coded = write_surface_uvs(mesh.uvs, bound, surface);
  EXPECT_TRUE(coded);
  if (!coded) return 0;
  const auto read = read_surface_uvs(coded->bytes, surface);
  EXPECT_TRUE(read) << (read ? "" : describe(read.error()));
  if (!read) return 0;
  EXPECT_EQ(*read, coded->values);
  EXPECT_EQ(read->size(), mesh.uvs.size());
  EXPECT_LE(largest_error(mesh.uvs, *read), bound);
  EXPECT_EQ(write_surface_uvs(mesh.uvs, bound, surface)->bytes, coded->bytes);
  return coded->bytes.size();
}

/// Whether the corner's face has it at `vertex`.
bool has_corner(const test::Soup& soup, const Corner& corner, std::uint32_t vertex) {
  const std::uint32_t* const v = soup.triangles.data() + std::size_t{3} * corner.face;
  for (std::size_t k = 0; k < 3; ++k)
    if (v[k] == vertex && v[(k + 1) % 3] == corner.next && v[(k + 2) % 3] == corner.before) return true;
  return false;
}

TEST(SurfaceOrder, ATTR30ListsVerticesAndFacesOnce) {
  std::vector<test::Soup> soups = {test::grid(7, 5, false, false, 0, 1), test::grid(6, 6, true, true, 4, 2),
                                   test::fan(9, true), test::moebius_strip(8)};
  for (std::uint32_t seed = 0; seed < 50; ++seed) soups.push_back(test::random_soup(seed, 12, 20));
  for (const test::Soup& soup : soups) {
    const SurfaceOrder order = make_surface_order(soup.triangles, soup.vertex_count,
                                                  VertexCorners(soup.triangles, soup.vertex_count));
    ASSERT_EQ(order.vertices.size(), soup.vertex_count) << soup.name;
    ASSERT_EQ(order.complete.size(), soup.triangles.size() / 3) << soup.name;
    std::vector<bool> visited(soup.vertex_count);
    std::vector<bool> complete(soup.triangles.size() / 3);
    for (std::size_t i = 0; i < order.vertices.size(); ++i) {
      EXPECT_FALSE(visited[order.vertices[i]]) << soup.name;
      visited[order.vertices[i]] = true;
      for (const Corner& corner : order.completed_by(i)) {
        EXPECT_TRUE(has_corner(soup, corner, order.vertices[i])) << soup.name;
        EXPECT_TRUE(visited[corner.next]) << soup.name;
        EXPECT_TRUE(visited[corner.before]) << soup.name;
        EXPECT_FALSE(complete[corner.face]) << soup.name;
        complete[corner.face] = true;
      }
    }
  }
}

TEST(SurfaceOrder, ATTR30TakesVerticesThatSeveralFacesWaitForFirst) {
  // A fan around 0: after 0, 1 and 2 one face waits for 3 and another, the last, for 4; then two for the
  // other.
  const std::vector<std::uint32_t> fan = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};
  const SurfaceOrder order = make_surface_order(fan, 6, VertexCorners(fan, 6));
  EXPECT_EQ(std::vector<std::uint32_t>(order.vertices.begin(), order.vertices.end()),
            (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(std::vector<std::uint32_t>(order.ends.begin(), order.ends.end()),
            (std::vector<std::uint32_t>{0, 0, 1, 2, 4, 4}));
}

TEST(SurfaceUvs, ATTR31StepOutOfRangeIsRefused) {
  const Textured mesh = patch(4, 0, turned_texture);
  const auto coded = write_surface_uvs(mesh.uvs, 1e-3, mesh.surface());
  ASSERT_TRUE(coded);
  for (const float step : {0.0F, -1.0F, 0x1p-101F, 0x1p65F, std::numeric_limits<float>::infinity(),
                           std::numeric_limits<float>::quiet_NaN()}) {
    auto bytes = coded->bytes;
    const auto bits = std::bit_cast<std::uint32_t>(step);
    for (std::size_t k = 0; k < 4; ++k) bytes[k] = static_cast<std::byte>(bits >> (8 * k));
    const auto read = read_surface_uvs(bytes, mesh.surface());
    ASSERT_FALSE(read) << step;
    EXPECT_STREQ(read.error().rule, "ATTR-31");
  }
}

TEST(SurfaceUvs, ATTR32FacesKeepTheirShape) {
  // A bent sheet that keeps all lengths: nearly nothing but the first vertices is left to code.
  Textured mesh;
  constexpr std::uint32_t kSide = 30;
  mesh.triangles = test::grid(kSide - 1, kSide - 1, false, false, 0, 3).triangles;
  for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
    const double s = (i % kSide + 0.3 * noise(i)) / kSide;
    const double t = (i / kSide + 0.3 * noise(i + 7919)) / kSide;  // NOLINT(bugprone-integer-division)
    mesh.add({std::sin(s), std::cos(s), t}, 0.3 * s - 0.4 * t, 0.4 * s + 0.3 * t);
  }
  const std::size_t bytes = code(mesh, 1e-3);
  EXPECT_LT(bytes, 110U);
  // Mirrored it is no dearer.
  Textured mirrored = mesh;
  for (std::size_t i = 0; i < mirrored.uvs.size(); i += 2) mirrored.uvs[i] = 1 - mirrored.uvs[i];
  EXPECT_LT(code(mirrored, 1e-3), 120U);
}

TEST(SurfaceUvs, ATTR33TextureGoesOnAsOnTheFaceBefore) {
  // Stretched by 5 along one axis of a plane, where faces do not keep their shape.
  const auto stretched = [](double s, double t) { return std::array<double, 2>{s, 0.2 * t}; };
  EXPECT_LT(code(patch(30, 0, stretched), 1e-3), 100U);
}

TEST(LinearFit, ATTR34FindsALinearFunction) {
  LinearFit fit;
  EXPECT_EQ(fit.at({0.1, 0.2, 0.3})[0], 0);
  const auto function = [](const Vec3& z) {
    return TwoDoubles{3 + z[0] - 2 * z[1] + 0.5 * z[2], -1 + 4 * z[2]};
  };
  for (std::uint32_t i = 0; i < 61; ++i) {
    const Vec3 z{noise(i), noise(3 * i + 1), noise(5 * i + 2)};
    fit.learn(z, function(z));
  }
  const Vec3 z{0.2, -0.3, 0.1};
  EXPECT_NEAR(fit.at(z)[0], function(z)[0], 1e-4);
  EXPECT_NEAR(fit.at(z)[1], function(z)[1], 1e-4);
  // After it fades few samples are enough to learn another.
  fit.fade();
  for (std::uint32_t i = 0; i < 12; ++i) {
    const Vec3 y{noise(i), noise(3 * i + 1), noise(5 * i + 2)};
    fit.learn(y, -1 * function(y));
  }
  EXPECT_NEAR(fit.at(z)[0], -function(z)[0], 0.05);
}

TEST(PredictionBlend, ATTR35LearnsWhatPredictionsAreWorth) {
  PredictionBlend blend;
  PredictionDifferences d{};
  for (std::uint32_t i = 0; i < 400; ++i) {
    for (std::uint32_t k = 0; k < 2; ++k) d[k] = TwoDoubles{noise(6 * i + 2 * k), noise(6 * i + 2 * k + 1)};
    blend.learn(d, 0.75 * d[0] - 0.25 * d[1], 1);
  }
  const TwoDoubles correction = blend.correction(d);
  const TwoDoubles expected = 0.75 * d[0] - 0.25 * d[1];
  EXPECT_NEAR(correction[0], expected[0], 0.01);
  EXPECT_NEAR(correction[1], expected[1], 0.01);
}

TEST(SurfaceUvs, ATTR36CopiesThatAreEqualCostNothing) {
  const auto texture = [](double s, double t) {
    return std::array<double, 2>{s + 0.1 * t * t, t - 0.2 * s * s};
  };
  const Textured once = patch(20, 0.1, texture);
  // Every face with corners of its own, as where normals are those of faces.
  Textured split;
  for (const std::uint32_t v : once.triangles) {
    split.triangles.push_back(split.count());
    split.geometric.push_back(v);
    const auto at = [&](const std::vector<float>& from, std::size_t i) {
      return static_cast<double>(from[i]);
    };
    split.add({at(once.positions, 3 * v), at(once.positions, 3 * v + 1), at(once.positions, 3 * v + 2)},
              at(once.uvs, 2 * v), at(once.uvs, 2 * v + 1));
  }
  const std::size_t known = code(split, 1e-4);
  Textured strangers = split;
  strangers.geometric.clear();
  EXPECT_LT(2 * known, code(strangers, 1e-4));
}

TEST(SurfaceUvs, ATTR37KeepsTheBoundOnAnyScale) {
  const auto texture = [](double s, double t) {
    return std::array<double, 2>{s + 0.1 * t * t, std::sin(9 * t)};
  };
  for (const double scale : {1e-12, 1e-3, 1.0, 1e6, 1e15}) {
    Textured mesh = patch(12, 0.2, texture);
    for (float& x : mesh.uvs) x = static_cast<float>(x * scale);
    for (const double share : {1e-4, 1e-2, 1.0, 100.0}) code(mesh, share * scale);
    for (float& x : mesh.positions) x = static_cast<float>(x * 1e30);
    code(mesh, 1e-3 * scale);
    for (float& x : mesh.positions) x = static_cast<float>(x * 1e-35 * 1e-30);
    code(mesh, 1e-3 * scale);
    mesh.positions.clear();
    code(mesh, 1e-3 * scale);
  }
}

TEST(SurfaceUvs, ATTR37KeepsBoundsThatFloatsHardlyReach) {
  const auto texture = [](double s, double t) { return std::array<double, 2>{s + 3, std::sin(9 * t) - 2}; };
  const Textured mesh = patch(60, 0.2, texture);
  for (const double bound : {1e-3, 1e-4, 4e-5, 2e-5}) code(mesh, bound);
}

TEST(SurfaceUvs, ATTR37NumbersOutOfRangeAreRefused) {
  // Bits that no writer makes: any stream fails or gives finite coordinates.
  const Textured mesh = patch(6, 0.2, turned_texture);
  auto bytes = write_surface_uvs(mesh.uvs, 1e-5, mesh.surface())->bytes;
  std::uint32_t state = 5;
  for (int trial = 0; trial < 2000; ++trial) {
    auto broken = bytes;
    for (int flips = 0; flips < 3; ++flips) {
      state = state * 1664525U + 1013904223U;
      broken[4 + (state >> 8) % (broken.size() - 4)] ^= static_cast<std::byte>(1U << (state >> 29));
    }
    const auto read = read_surface_uvs(broken, mesh.surface());
    if (!read) continue;
    for (const float x : *read) EXPECT_TRUE(std::isfinite(x));
  }
}

TEST(SurfaceUvs, DegenerateFacesAndLooseVertices) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const test::Soup soup = test::random_soup(seed, 30, 40);
    Textured mesh;
    mesh.triangles = soup.triangles;
    for (std::uint32_t v = 0; v < soup.vertex_count; ++v) {
      // Some places and some texture coordinates coincide, or lie on a line.
      const double s = v % 5;
      mesh.add({s, v % 3 == 0 ? 0 : noise(v), seed % 2 == 0 ? 0 : noise(v + 100)}, v % 4 == 0 ? 0.5 : s,
               seed % 3 == 0 ? 0 : noise(v + 200));
      mesh.geometric.push_back(v % 7 == 6 ? v - 1 : v);
    }
    code(mesh, 1e-3);
    mesh.positions.clear();
    code(mesh, 1e-3);
  }
  Textured none;
  EXPECT_GT(code(none, 1e-3), 0U);
}

TEST(SurfaceUvs, WhatDoesNotSuitIsLeftToOtherCodings) {
  Textured mesh = patch(5, 0, turned_texture);
  EXPECT_FALSE(write_surface_uvs(mesh.uvs, 0, mesh.surface()));
  EXPECT_FALSE(write_surface_uvs(mesh.uvs, 1e-8, mesh.surface()));
  EXPECT_FALSE(write_surface_uvs(mesh.uvs, 1e30, mesh.surface()));
  mesh.uvs[7] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(write_surface_uvs(mesh.uvs, 1e-3, mesh.surface()));
  mesh.uvs[7] = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(write_surface_uvs(mesh.uvs, 1e-3, mesh.surface()));
}

TEST(SurfaceUvs, PrefixesAndMoreBytesAreRefused) {
  const Textured mesh = patch(8, 0.2, turned_texture);
  const auto bytes = write_surface_uvs(mesh.uvs, 1e-4, mesh.surface())->bytes;
  const auto read = [&](const test::Bytes& some) {
    return read_surface_uvs(some, mesh.surface()).has_value();
  };
  test::expect_guarded(bytes, read, "uvs");
}

/// A wheel: the hub has a corner in every face.
Textured wheel(std::uint32_t faces) {
  Textured mesh;
  mesh.add({0, 0, 0.1}, 0.5, 0.5);
  for (std::uint32_t i = 0; i < faces; ++i) {
    const double angle = 6.283185307179586 * i / faces;
    mesh.add({std::cos(angle), std::sin(angle), 0}, 0.5 + 0.5 * std::cos(angle), 0.5 + 0.5 * std::sin(angle));
    mesh.triangles.insert(mesh.triangles.end(), {0, 1 + i, 1 + (i + 1) % faces});
  }
  return mesh;
}

TEST(Attribute, ATTR32AHubTakesLinearTime) {
  const auto time_of = [](std::uint32_t faces) {
    const std::clock_t begin = std::clock();
    code(wheel(faces), 0.001);
    return std::max(std::clock() - begin, std::clock_t{CLOCKS_PER_SEC / 100});
  };
  EXPECT_LT(time_of(160000), 24 * time_of(20000));  // 8 in theory; quadratic would be 64
}

}  // namespace
}  // namespace deltamesh::surface_uvs_test
