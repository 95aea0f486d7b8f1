// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include <limits>

#include "curves/hull.h"

namespace deltamesh::bench {
namespace {

TEST(Curve, HullDropsDominatedAndConcavePoints) {
  // Two points on a line over log error, one above the line, one dominated, one without meaning.
  const CurvePoint points[] = {{16, 100}, {1, 500}, {4, 350}, {32, 200}, {0, 5}};
  const auto hull = lower_hull(points);
  ASSERT_EQ(hull.size(), 2U);
  EXPECT_EQ(hull[0].bytes, 500);
  EXPECT_EQ(hull[1].bytes, 100);
}

TEST(Curve, HullKeepsConvexPointsInOrder) {
  const CurvePoint points[] = {{4, 100}, {1, 1000}, {2, 200}};
  const auto hull = lower_hull(points);
  ASSERT_EQ(hull.size(), 3U);
  EXPECT_EQ(hull[1].error, 2);
}

TEST(Curve, HullOfEqualErrorsTakesTheFewestBytes) {
  const CurvePoint points[] = {{1, 300}, {1, 200}, {1, std::numeric_limits<double>::infinity()}};
  const auto hull = lower_hull(points);
  ASSERT_EQ(hull.size(), 1U);
  EXPECT_EQ(hull[0].bytes, 200);
}

TEST(Curve, ABitPerHalvingIsExact) {
  const CurvePoint points[] = {{1, 1000}, {16, 200}};
  const auto hull = lower_hull(points);
  EXPECT_NEAR(bytes_at(hull, 1).value(), 1000, 1e-9);
  EXPECT_NEAR(bytes_at(hull, 2).value(), 800, 1e-9);
  EXPECT_NEAR(bytes_at(hull, 8).value(), 400, 1e-9);
}

TEST(Curve, OutsideTheHullIsBoundOrNothing) {
  const CurvePoint points[] = {{1, 1000}, {100, 10}};
  const auto hull = lower_hull(points);
  EXPECT_EQ(bytes_at(hull, 500).value(), 10);
  EXPECT_FALSE(bytes_at(hull, 0.99).has_value());
  EXPECT_FALSE(bytes_at({}, 1).has_value());
}

}  // namespace
}  // namespace deltamesh::bench
