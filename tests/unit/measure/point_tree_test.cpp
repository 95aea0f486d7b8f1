// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "measure/tree/point_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace deltamesh {
namespace {

/// A wall at right angles to the first axis, rough by 0.01; coordinates repeat, so that there are ties.
std::vector<Vec3> wall(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  const auto below = [&](unsigned most) { return static_cast<double>(random() % most); };
  std::vector<Vec3> points(count);
  for (Vec3& point : points) point = {0.001 * below(10), 0.01 * below(1000), 0.01 * below(1000)};
  return points;
}

std::vector<std::uint32_t> nearest_of_all(const std::vector<Vec3>& points, const Vec3& p, std::size_t count,
                                          double most) {
  std::vector<NearPoint> all;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Vec3 apart = p - points[i];
    if (dot(apart, apart) <= most) all.push_back({.squared_distance = dot(apart, apart), .point = i});
  }
  std::sort(all.begin(), all.end());
  std::vector<std::uint32_t> nearest;
  for (std::size_t i = 0; i < std::min(count, all.size()); ++i) nearest.push_back(all[i].point);
  return nearest;
}

TEST(PointTree, AgreesWithTryingAll) {
  const std::vector<Vec3> points = wall(3000, 1);
  const PointTree tree(points);
  std::vector<NearPoint> found;
  for (const Vec3& p : {Vec3{0, 5, 5}, Vec3{10, 5, 5}, Vec3{0, -3, 20}, Vec3{1000, 2, 2}, points[7]})
    for (const double most : {0.0, 0.01, 110.0, 1e300}) {
      tree.nearest(p, 16, found, most);
      std::vector<std::uint32_t> indices;
      for (const NearPoint& near : found) indices.push_back(near.point);
      EXPECT_EQ(indices, nearest_of_all(points, p, 16, most));
    }
}

TEST(PointTree, HasNothingNearWithoutPoints) {
  std::vector<NearPoint> found(1);
  PointTree({}).nearest({}, 16, found);
  EXPECT_TRUE(found.empty());
}

// Splits alone, without boxes, do not tell that most of a wall is farther than the rest.
TEST(BoxTree, VisitsFewItemsFromAfar) {
  const std::vector<Vec3> points = wall(100000, 2);
  std::vector<std::uint32_t> all(points.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  const BoxTree tree(points, all, 1);
  for (const double away : {1.0, 10.0, 100.0}) {
    double nearest = 1e300;
    std::size_t visited = 0;
    tree.visit_near(
        {away, 5, 5}, [&](double squared_distance) { return squared_distance > nearest; },
        [&](std::uint32_t point) {
          const Vec3 apart = Vec3{away, 5, 5} - points[point];
          nearest = std::min(nearest, dot(apart, apart));
          ++visited;
        });
    EXPECT_LT(visited, 2000) << away;
  }
}

}  // namespace
}  // namespace deltamesh
