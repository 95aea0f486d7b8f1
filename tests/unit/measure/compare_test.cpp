// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "support/meshes.h"

namespace deltamesh {
namespace {

/// An n x n grid of squares over [0, 1]^2 at height z; `flip` cuts the squares along the other diagonal.
Mesh grid(std::uint32_t n, float z, bool flip = false) {
  Mesh mesh;
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x)
      mesh.positions.insert(mesh.positions.end(), {static_cast<float>(x) / static_cast<float>(n),
                                                   static_cast<float>(y) / static_cast<float>(n), z});
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t a = y * (n + 1) + x;
      const std::uint32_t b = a + 1;
      const std::uint32_t c = a + n + 1;
      const std::uint32_t d = c + 1;
      if (flip)
        mesh.triangles.insert(mesh.triangles.end(), {a, b, c, b, d, c});
      else
        mesh.triangles.insert(mesh.triangles.end(), {a, b, d, a, d, c});
    }
  return mesh;
}

/// Closed, all normals outward.
Mesh octahedron() {
  Mesh mesh;
  mesh.positions = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
  mesh.triangles = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
  return mesh;
}

TEST(Compare, FindsNoDifferenceToItself) {
  const Mesh mesh = octahedron();
  const auto result = compare(mesh, mesh);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->corresponding);
  EXPECT_EQ(result->quality.vde_rms, 0);
  EXPECT_EQ(result->quality.lfe_rms, 0);
  EXPECT_EQ(result->quality.max_error, 0);
  EXPECT_EQ(result->normal_angle_p95, 0);
  EXPECT_EQ(result->measured_vertices, 6U);
  EXPECT_DOUBLE_EQ(result->diagonal, std::sqrt(12.0));
}

TEST(Compare, MeasuresAShift) {
  const Mesh a = grid(4, 0);
  Mesh b = a;
  for (std::size_t i = 0; i < b.positions.size(); i += 3) b.positions[i] += 0.25F;
  const auto result = compare(a, b);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->corresponding);
  EXPECT_DOUBLE_EQ(result->quality.lfe_rms, 0.25);
  EXPECT_DOUBLE_EQ(result->quality.max_error, 0.25);
  EXPECT_NEAR(result->quality.vde_rms, 0, 1e-15);
  EXPECT_EQ(*std::max_element(result->signed_error.begin(), result->signed_error.end()), 0);
}

TEST(Compare, SignsErrorsOutwardPositive) {
  const Mesh a = octahedron();
  Mesh b = a;
  b.positions[0] = 1.5F;
  b.positions[1] = 0.5F;  // along the surface: no part of the signed error
  b.positions[3] = -0.75F;
  const auto result = compare(a, b);
  ASSERT_TRUE(result);
  EXPECT_FLOAT_EQ(result->signed_error[0], 0.5F);
  EXPECT_FLOAT_EQ(result->signed_error[1], -0.25F);
  EXPECT_FLOAT_EQ(result->signed_error[2], 0);
  EXPECT_DOUBLE_EQ(result->quality.max_error, std::sqrt(0.5));
  EXPECT_GT(result->normal_angle_mean, 0);
  EXPECT_GE(result->normal_angle_p95, result->normal_angle_mean);
}

TEST(Compare, FollowsTheOrder) {
  const Mesh a = grid(5, 0);
  auto [b, order] = test::shuffled(a, 5);
  b.positions[2] += 0.125F;
  const auto result = compare(a, b, order);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->corresponding);
  EXPECT_DOUBLE_EQ(result->quality.max_error, 0.125);
  EXPECT_FLOAT_EQ(result->signed_error[0], 0.125F);
}

TEST(Compare, FindsTheOrder) {
  const Mesh a = grid(20, 0);
  auto [b, order] = test::shuffled(a, 5);
  std::mt19937 random(7);
  std::uniform_real_distribution<float> noise(-0.02F, 0.02F);  // edges are 0.05
  for (float& x : b.positions) x += noise(random);
  const auto told = compare(a, b, order);
  const auto found = compare(a, b);
  ASSERT_TRUE(told);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->corresponding);
  EXPECT_TRUE(found->reordered);
  EXPECT_FALSE(told->reordered);
  EXPECT_EQ(found->matched_faces, 800U);
  EXPECT_EQ(found->quality.max_error, told->quality.max_error);
  EXPECT_DOUBLE_EQ(found->quality.vde_rms, told->quality.vde_rms);
  EXPECT_EQ(found->signed_error, told->signed_error);
}

TEST(Compare, DoesNotMissFacesThatDrawNothing) {
  const Mesh a = octahedron();
  Mesh b = test::shuffled(a, 5).mesh;
  b.triangles.insert(b.triangles.end(), {2, 3, 3});
  for (const bool first : {true, false}) {
    const auto result = first ? compare(a, b) : compare(b, a);
    ASSERT_TRUE(result);
    EXPECT_TRUE(result->corresponding);
    EXPECT_EQ(result->matched_faces, 8U);
    EXPECT_EQ(result->unmatched_faces_b, first ? 1U : 0U);
    EXPECT_EQ(result->quality.max_error, 0);
  }
}

TEST(Compare, DoesNotMissVerticesThatNoFaceUses) {
  const Mesh a = octahedron();
  Mesh b = test::shuffled(a, 5).mesh;
  b.positions.insert(b.positions.end(), {7, 7, 7, 9, 9, 9});
  for (const bool first : {true, false}) {
    const auto result = first ? compare(a, b) : compare(b, a);
    ASSERT_TRUE(result);
    EXPECT_TRUE(result->corresponding);
    EXPECT_EQ(result->measured_vertices, 6U);
    EXPECT_EQ(result->quality.max_error, 0);
    EXPECT_EQ(result->signed_error.back(), 0);
  }
}

TEST(Compare, TakesPointsForVerticesThatCount) {
  Mesh a;
  a.positions = {0, 0, 0, 1, 0, 0};
  Mesh b;
  b.positions = {0, 0, 0, 5, 5, 5, 9, 9, 9};
  const auto result = compare(a, b);
  EXPECT_FALSE(result && result->corresponding);
  EXPECT_FALSE(compare(Mesh{}, b));
}

/// Their numbers are alike in every order.
TEST(Compare, FindsTheOrderOfFacesWithoutCommonVertices) {
  constexpr std::uint32_t kFaces = 100;
  Mesh a;
  Mesh b;
  for (std::uint32_t i = 0; i < kFaces; ++i) {
    const auto add = [&](Mesh& mesh, std::uint32_t face, float error) {
      const float x = 3 * static_cast<float>(face);
      mesh.positions.insert(mesh.positions.end(), {x, error, 0, x + 1, 0, 0, x, 1, 0});
      mesh.triangles.insert(mesh.triangles.end(), {3 * i, 3 * i + 1, 3 * i + 2});
    };
    add(a, i, 0);
    add(b, (i * 7 + 5) % kFaces, 0.125F);
  }
  const auto result = compare(a, b);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->corresponding);
  EXPECT_TRUE(result->reordered);
  EXPECT_DOUBLE_EQ(result->quality.max_error, 0.125);
}

/// Errors of many edges do not change which vertex is which.
TEST(Compare, FollowsNumbersThroughLargeErrors) {
  const Mesh a = grid(20, 0);
  Mesh b = a;
  for (float& x : b.positions) x += 0.5F;
  const auto result = compare(a, b);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->corresponding);
  EXPECT_FALSE(result->reordered);
  EXPECT_NEAR(result->quality.max_error, 0.5 * std::sqrt(3.0), 1e-6);
}

TEST(Compare, FindsTheOrderOfPoints) {
  Mesh a = grid(6, 0);
  a.triangles.clear();
  const Mesh b = test::shuffled(a, 5).mesh;
  Mesh fewer = b;
  fewer.positions.resize(fewer.positions.size() - 3);
  for (const Mesh& points : {b, fewer}) {
    const auto result = compare(a, points);
    ASSERT_TRUE(result);
    EXPECT_TRUE(result->corresponding);
    EXPECT_EQ(result->quality.max_error, 0);
  }
}

TEST(Compare, MeasuresSurfacesOfOtherTriangulations) {
  const auto result = compare(grid(7, 0), grid(3, 0.125F, true));
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->corresponding);
  EXPECT_EQ(result->matched_faces, 0U);
  EXPECT_EQ(result->unmatched_faces_a, 98U);
  EXPECT_EQ(result->unmatched_faces_b, 18U);
  EXPECT_DOUBLE_EQ(result->surface_rms, 0.125);
  EXPECT_DOUBLE_EQ(result->surface_max, 0.125);
  EXPECT_NEAR(result->normal_angle_mean, 0, 1e-9);
  for (const float error : result->signed_error) EXPECT_FLOAT_EQ(error, 0.125F);
}

TEST(Compare, CountsBothDirections) {
  const Mesh small = grid(1, 0);
  Mesh large = grid(2, 0);
  for (float& x : large.positions) x *= 2;
  const auto result = compare(small, large);
  ASSERT_TRUE(result);
  EXPECT_DOUBLE_EQ(result->surface_max, std::sqrt(2.0));  // corner (2, 2) to (1, 1)
  const auto back = compare(large, small);
  ASSERT_TRUE(back);
  EXPECT_DOUBLE_EQ(back->surface_rms, result->surface_rms);
}

TEST(Compare, SeesOrientationAndMultiplicity) {
  const Mesh a = octahedron();
  Mesh flipped = a;
  std::swap(flipped.triangles[0], flipped.triangles[1]);
  EXPECT_FALSE(compare(a, flipped)->corresponding);
  EXPECT_EQ(compare(a, flipped)->matched_faces, 7U);
  EXPECT_EQ(compare(a, flipped)->unmatched_faces_a, 1U);
  Mesh twice = a;
  std::copy_n(a.triangles.begin(), 3, twice.triangles.begin() + 3);
  EXPECT_FALSE(compare(a, twice)->corresponding);
  EXPECT_TRUE(compare(twice, twice)->corresponding);
}

TEST(Compare, AcceptsDroppedVertices) {
  Mesh a = octahedron();
  a.positions.insert(a.positions.begin(), {100, 100, 100});  // no face uses it
  for (std::uint32_t& v : a.triangles) ++v;
  const Mesh b = octahedron();
  const std::vector<std::uint32_t> order{1, 2, 3, 4, 5, 6};
  const auto result = compare(a, b, order);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->corresponding);
  EXPECT_EQ(result->quality.max_error, 0);
  EXPECT_DOUBLE_EQ(result->diagonal, std::sqrt(12.0));
  const auto found = compare(a, b);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->corresponding);
  EXPECT_EQ(found->quality.max_error, 0);
  const auto back = compare(b, a);  // the vertex without a face has no partner
  ASSERT_TRUE(back);
  EXPECT_TRUE(back->corresponding);
  EXPECT_EQ(back->matched_faces, 8U);
  EXPECT_EQ(back->quality.max_error, 0);
}

TEST(Compare, WeldsSeamsButSeesCracks) {
  Mesh a = grid(1, 0);
  a.positions.insert(a.positions.end(), {a.positions[0], a.positions[1], a.positions[2]});
  a.triangles[3] = 4;  // the second triangle starts at a copy of vertex 0
  const auto same = compare(a, a);
  ASSERT_TRUE(same);
  EXPECT_EQ(same->measured_vertices, 4U);
  Mesh cracked = a;
  cracked.positions[14] = 0.5F;
  const auto result = compare(a, cracked);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->quality.lfe_rms, 0);
  EXPECT_DOUBLE_EQ(result->quality.max_error, 0.5);
}

TEST(Compare, AddsTheOrigins) {
  Mesh a = grid(3, 0);
  a.origin = {500000, 5100000, 1000};
  Mesh b = a;
  b.origin = {499999, 5100000, 1000};
  for (std::size_t i = 0; i < b.positions.size(); i += 3) b.positions[i] += 1.0F;
  const auto result = compare(a, b);
  ASSERT_TRUE(result);
  EXPECT_LT(result->quality.max_error, 1e-7);
}

TEST(Compare, CountsWhatBecameFloat32) {
  const Mesh mesh = grid(4, 0);
  std::vector<float> higher(mesh.positions.size(), 0);
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) higher[3 * v + 2] = 1e-5F;
  const auto [other, order] = test::shuffled(mesh, 5);
  EXPECT_FLOAT_EQ(static_cast<float>(compare(mesh, mesh, {}, {.a = higher})->quality.max_error), 1e-5F);
  EXPECT_FLOAT_EQ(static_cast<float>(compare(mesh, other, order, {.b = higher})->quality.max_error), 1e-5F);
  EXPECT_EQ(compare(mesh, other, order, {.a = higher, .b = higher})->quality.max_error, 0);
  EXPECT_FLOAT_EQ(static_cast<float>(compare(mesh, grid(4, 0, true), {}, {.b = higher})->surface_max), 1e-5F);
  higher.pop_back();
  EXPECT_EQ(compare(mesh, mesh, {}, {.a = higher}).error().code, ErrorCode::kInvalidArgument);
}

TEST(Compare, RejectsBadOrders) {
  const Mesh a = octahedron();
  const std::vector<std::uint32_t> outside{0, 1, 2, 3, 4, 6};
  const auto result = compare(a, a, outside);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(result.error().where, 5U);
  const std::vector<std::uint32_t> too_short{0, 1, 2};
  EXPECT_EQ(compare(a, a, too_short).error().code, ErrorCode::kInvalidArgument);
  const std::vector<std::uint32_t> repeated{0, 1, 2, 3, 4, 4};
  const auto double_use = compare(a, a, repeated);
  ASSERT_TRUE(double_use);
  EXPECT_FALSE(double_use->corresponding);
}

TEST(Compare, RejectsBadMeshes) {
  const Mesh good = octahedron();
  Mesh bad = good;
  bad.positions[7] = std::numeric_limits<float>::quiet_NaN();
  const auto not_finite = compare(good, bad);
  ASSERT_FALSE(not_finite);
  EXPECT_EQ(not_finite.error().code, ErrorCode::kNotFinite);
  EXPECT_EQ(not_finite.error().where, 2U);
  bad = good;
  bad.triangles[4] = 6;
  EXPECT_EQ(compare(bad, good).error().where, 1U);
  bad = good;
  bad.positions.pop_back();
  EXPECT_FALSE(compare(good, bad));
  bad = good;
  bad.origin[1] = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(compare(good, bad));
}

TEST(Compare, TakesEmptyAndDegenerateMeshes) {
  const auto empty = compare(Mesh{}, Mesh{});
  ASSERT_TRUE(empty);
  EXPECT_TRUE(empty->corresponding);
  EXPECT_EQ(empty->diagonal, 0);
  EXPECT_EQ(compare(octahedron(), Mesh{}).error().code, ErrorCode::kInvalidArgument);

  Mesh point;
  point.positions = {3, 0, 0};
  const auto to_point = compare(octahedron(), point);
  ASSERT_TRUE(to_point);
  EXPECT_DOUBLE_EQ(to_point->surface_max, 4);

  Mesh line = octahedron();
  line.triangles = {0, 1, 0, 2, 2, 2, 0, 1, 1};
  ASSERT_TRUE(compare(line, line));
  EXPECT_TRUE(compare(line, line)->corresponding);
  const auto to_line = compare(octahedron(), line);
  ASSERT_TRUE(to_line);
  EXPECT_DOUBLE_EQ(to_line->surface_max, 1);
  EXPECT_EQ(to_line->normal_angle_p95, 0);
}

}  // namespace
}  // namespace deltamesh
