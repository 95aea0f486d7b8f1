// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "measure/tree/triangle_tree.h"

#include <gtest/gtest.h>

#include <random>

namespace deltamesh {
namespace {

std::vector<Vec3> random_points(std::size_t count, unsigned seed, double scale) {
  std::mt19937 random(seed);
  std::vector<Vec3> points(count);
  for (Vec3& point : points)
    for (double& coordinate : point)
      coordinate = scale * (static_cast<double>(random()) / 4294967295.0 - 0.5);
  return points;
}

/// The smallest distance over a fine lattice of the triangle's points.
double sampled_distance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  constexpr int kSteps = 60;
  double best = 1e300;
  for (int i = 0; i <= kSteps; ++i)
    for (int j = 0; i + j <= kSteps; ++j) {
      const double s = static_cast<double>(i) / kSteps;
      const double t = static_cast<double>(j) / kSteps;
      best = std::fmin(best, length(p - ((1 - s - t) * a + s * b + t * c)));
    }
  return best;
}

TEST(NearestOnTriangle, AgreesWithSampling) {
  const std::vector<Vec3> points = random_points(400, 1, 2);
  for (std::size_t i = 0; i + 4 <= points.size(); i += 4) {
    const SurfacePoint point = nearest_on_triangle(points[i], points[i + 1], points[i + 2], points[i + 3]);
    const double sampled = sampled_distance(points[i], points[i + 1], points[i + 2], points[i + 3]);
    EXPECT_LE(std::sqrt(point.squared_distance), sampled + 1e-12);
    EXPECT_GE(std::sqrt(point.squared_distance), sampled - 0.05);
    double sum = 0;
    for (const double weight : point.weights) {
      EXPECT_GE(weight, 0);
      sum += weight;
    }
    EXPECT_NEAR(sum, 1, 1e-12);
  }
}

TEST(NearestOnTriangle, TreatsDegenerateTrianglesAsEdges) {
  const Vec3 a{0, 0, 0};
  const Vec3 b{2, 0, 0};
  EXPECT_DOUBLE_EQ(nearest_on_triangle({1, 3, 0}, a, b, a).squared_distance, 9);
  EXPECT_DOUBLE_EQ(nearest_on_triangle({1, 3, 0}, a, {1, 0, 0}, b).squared_distance, 9);
  EXPECT_DOUBLE_EQ(nearest_on_triangle({0, 3, 4}, a, a, a).squared_distance, 25);
}

TEST(TriangleTree, AgreesWithTryingAll) {
  const std::vector<Vec3> corners = random_points(600, 2, 1);
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t i = 0; i + 2 < corners.size(); ++i) triangles.insert(triangles.end(), {i, i + 1, i + 2});
  for (std::uint32_t i = 0; i < 20; ++i) triangles.insert(triangles.end(), {i, i, i + 1});
  triangles.insert(triangles.end(), triangles.begin(), triangles.begin() + 30);
  const TriangleTree tree(corners, triangles);
  std::uint32_t hint = 0;
  for (const Vec3& p : random_points(200, 3, 3)) {
    double best = 1e300;
    for (std::size_t i = 0; i < triangles.size(); i += 3)
      best = std::fmin(best, nearest_on_triangle(p, corners[triangles[i]], corners[triangles[i + 1]],
                                                 corners[triangles[i + 2]])
                                 .squared_distance);
    const SurfacePoint point = tree.nearest(p, hint);
    EXPECT_EQ(point.squared_distance, best);
    hint = point.triangle;
  }
}

TEST(TriangleTree, HoldsManyEqualTriangles) {
  const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  std::vector<std::uint32_t> triangles;
  for (int i = 0; i < 1000; ++i) triangles.insert(triangles.end(), {0, 1, 2});
  EXPECT_DOUBLE_EQ(TriangleTree(corners, triangles).nearest({0.25, 0.25, 2}).squared_distance, 4);
}

}  // namespace
}  // namespace deltamesh
