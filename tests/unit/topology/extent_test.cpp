// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "topology/extent.h"

#include <gtest/gtest.h>

#include <vector>

namespace deltamesh {
namespace {

std::vector<Vec3> grid(int side) {
  std::vector<Vec3> points;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) points.push_back({double(x), double(y), 0.1 * ((x * 7 + y * 3) % 5)});
  return points;
}

Extent extent_around(const std::vector<Vec3>& points) { return extent_of(points, Box::around(points)); }

TEST(Extent, SIZ1IsTheBoxWithoutStrays) {
  for (const int side : {1, 2, 5, 20, 300}) {
    const std::vector<Vec3> points = grid(side);
    EXPECT_EQ(extent_around(points).diagonal, Box::around(points).diagonal());
    EXPECT_EQ(extent_around(points).strays, 0U);
  }
}

TEST(Extent, LeavesAFewFarVerticesOut) {
  for (const int side : {30, 300}) {
    std::vector<Vec3> points = grid(side);
    const double diagonal = Box::around(points).diagonal();
    points.insert(points.begin() + 7, {1e6, 0, 0});
    points.push_back({0, -1e30, 0});
    const Extent extent = extent_around(points);
    EXPECT_EQ(extent.diagonal, diagonal);
    EXPECT_EQ(extent.strays, 2U);
    EXPECT_TRUE(extent.is_stray(points.back()));
    EXPECT_FALSE(extent.is_stray(points[0]));
  }
}

TEST(Extent, ManyFarVerticesArePartOfTheMesh) {
  std::vector<Vec3> points = grid(100);
  for (int i = 0; i < 200; ++i) points.push_back({1e4 + i, 0, 0});
  EXPECT_EQ(extent_around(points).strays, 0U);
  EXPECT_EQ(extent_around(points).diagonal, Box::around(points).diagonal());
}

TEST(Extent, PointsAtOnePlaceHaveNoStrays) {
  std::vector<Vec3> points(100, Vec3{1, 2, 3});
  points.push_back({9, 9, 9});
  EXPECT_EQ(extent_around(points).strays, 0U);
}

}  // namespace
}  // namespace deltamesh
