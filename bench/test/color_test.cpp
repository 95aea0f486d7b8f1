// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include "colors/octree_levels.h"
#include "colors/rate_curves.h"
#include "scenes.h"

namespace deltamesh::bench {
namespace {

TEST(OctreeLevels, CopiesJoinFirstThenHalvesOfTheSmallestCells) {
  // Along x, in steps of the smallest cell: 0, 1, 2, 7 and a copy of 2; far away 2^20 - 1.
  const float positions[] = {0, 0, 0, 1, 0, 0, 2, 0, 0, 7, 0, 0, 2, 0, 0, 1048575, 0, 0};
  const AttributeSurface surface({}, 6, {}, positions);
  const auto levels = make_octree_levels(surface, OctreePrediction::kFromNeighbors);
  ASSERT_GE(levels.size(), 4U);
  EXPECT_EQ(levels.back().nodes.size(), 1U);
  EXPECT_EQ(levels.back().nodes[0].weight, 6U);
  const auto second_of = [&](std::size_t level, std::size_t node) {
    return levels[level].children[node].second;
  };
  EXPECT_EQ(levels[1].nodes.size(), 5U);
  EXPECT_EQ(second_of(1, 2), 4U);  // the copy
  EXPECT_EQ(second_of(2, 0), 1U);  // 0 and 1
  EXPECT_EQ(second_of(3, 0), 1U);  // 0 to 3
}

TEST(OctreeLevels, NothingIsPredictedWithoutNeighbors) {
  const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::uint32_t triangle[] = {0, 1, 2};
  const AttributeSurface surface(triangle, 3, {}, positions);
  EXPECT_EQ(make_octree_levels(surface, OctreePrediction::kFromNeighbors)[0].graph.neighbors.size(), 6U);
  for (const HaarLevel& level : make_octree_levels(surface, OctreePrediction::kNone))
    EXPECT_TRUE(level.graph.neighbors.empty());
}

TEST(ColorCurves, ErrorsRiseAndBytesFall) {
  const auto curves = measure_color_curves(*generate_scene(Scene::kRooms, 4000, 1));
  ASSERT_TRUE(curves);
  for (const auto& points : curves->points) {
    ASSERT_GE(points.size(), 2U);
    EXPECT_GT(points.front().decibels, points.back().decibels);
    EXPECT_LT(points.front().difference, points.back().difference);
    EXPECT_GT(points.front().bytes, points.back().bytes);
  }
  const RatePoint& point = curves->points[1][2];
  EXPECT_NEAR(curves->at(ColorCoder::kTransform, point.decibels).bytes, static_cast<double>(point.bytes),
              1e-6 * static_cast<double>(point.bytes));
}

}  // namespace
}  // namespace deltamesh::bench
