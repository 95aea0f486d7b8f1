// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/polygons/triangulate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "io/polygons/orientation.h"

namespace deltamesh::triangulate_test {
namespace {

using Points = std::vector<Vec3>;
using Triangles = std::vector<std::uint32_t>;

Triangles triangles_of(const Points& points) {
  Triangles triangles;
  EXPECT_TRUE(triangulate(points, triangles));
  EXPECT_EQ(triangles.size(), 3 * (points.size() - 2));
  return triangles;
}

double area(const Vec3& a, const Vec3& b, const Vec3& c) { return cross(b - a, c - a)[2] / 2; }

/// By the corners alone.
double area_of(const Points& points) {
  double sum = 0;
  for (std::size_t i = 2; i < points.size(); ++i) sum += area(points[0], points[i - 1], points[i]);
  return sum;
}

/// All triangles turn to the left, and they cover as much as the polygon: then none lies outside of it or on
/// another.
void expect_filled(const Points& points) {
  const Triangles triangles = triangles_of(points);
  double sum = 0;
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const double part = area(points[triangles[t]], points[triangles[t + 1]], points[triangles[t + 2]]);
    EXPECT_GE(part, 0);
    sum += part;
  }
  EXPECT_NEAR(sum, area_of(points), 1e-9 * std::fabs(sum));
}

TEST(Triangulate, FansWhereTheyFill) {
  EXPECT_EQ(triangles_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), (Triangles{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(triangles_of({{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}), (Triangles{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(triangles_of({{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {1, 3, 0}, {-1, 1, 0}}),
            (Triangles{0, 1, 2, 0, 2, 3, 0, 3, 4}));
  // Concave, but seen whole from corner 0.
  EXPECT_EQ(triangles_of({{1, 1, 0}, {0, 4, 0}, {-4, -4, 0}, {4, 0, 0}}), (Triangles{0, 1, 2, 0, 2, 3}));
}

TEST(Triangulate, ConcavePolygonsKeepTheirArea) {
  expect_filled(
      {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {9, 10, 0}, {9, 1, 0}, {1, 1, 0}, {1, 10, 0}, {0, 10, 0}});
  expect_filled({{4, 0, 0}, {1, 1, 0}, {0, 4, 0}, {-4, -4, 0}});  // arrow whose notch is corner 1
  expect_filled({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}});  // corners on sides
  expect_filled({{0, 0, 0},
                 {6, 0, 0},
                 {6, 6, 0},
                 {0, 6, 0},
                 {0, 0, 0},
                 {2, 2, 0},
                 {2, 4, 0},
                 {4, 4, 0},
                 {4, 2, 0},
                 {2, 2, 0}});  // a hole, joined by a bridge
}

TEST(Triangulate, RandomStarsAndCombs) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> radius(0.05, 1);
  for (int round = 0; round < 300; ++round) {
    const int n = 4 + round % 60;
    Points star;
    Points comb;
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * 3.141592653589793 * i / n;
      const double r = radius(random);
      star.push_back({r * std::cos(angle), r * std::sin(angle), 0});
      comb.push_back({static_cast<double>(i), i % 2 == 0 ? 0.0 : -radius(random), 0});
    }
    for (int i = n; i-- > 0;)
      comb.push_back({static_cast<double>(i), 0.5 + (i % 3 == 0 ? radius(random) : 0.0), 0});
    expect_filled(star);
    expect_filled(comb);
  }
}

TEST(Triangulate, WhatIsNotPlanarIsSeenAlongItsNormal) {
  Points points{{0, 0, 0.3}, {10, 0, -0.2}, {10, 10, 0.1}, {9, 10, 0},
                {9, 1, 0.4}, {1, 1, -0.5},  {1, 10, 0},    {0, 10, 0.2}};
  const Triangles flat = triangles_of(points);
  expect_filled(points);
  for (Vec3& p : points) p = {p[2], p[0], p[1]};  // another axis
  EXPECT_EQ(triangles_of(points), flat);
}

TEST(Triangulate, WhatHasNoAreaOrCrossesItselfStillHasAllTriangles) {
  triangles_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
  triangles_of({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}});
  triangles_of({{0, 0, 0}, {3, 3, 0}, {3, 0, 0}, {0, 2, 0}, {-1, 5, 0}});
  triangles_of({{0, 0, 0}, {1, std::nan(""), 0}, {1, 1, 0}, {0, 1, 0}});
  Points many(kMostEarCorners + 1, Vec3{0, 0, 0});
  for (std::size_t i = 0; i < many.size(); ++i)
    many[i] = {static_cast<double>(i), static_cast<double>(i % 2) + (i == 0 ? 9 : 0), 0};
  Triangles triangles;
  EXPECT_FALSE(triangulate(many, triangles));
}

TEST(Triangulate, LargePolygons) {
  Points spiral;  // hardly any ears, far from one another
  for (int i = 0; i < 1000; ++i)
    spiral.push_back({(10 + i) * std::cos(i * 0.05), (10 + i) * std::sin(i * 0.05), 0});
  for (int i = 1000; i-- > 0;)
    spiral.push_back({(8 + i) * std::cos(i * 0.05), (8 + i) * std::sin(i * 0.05), 0});
  expect_filled(spiral);
  Points line(kMostEarCorners);  // no ear is left once the one corner off the line is cut
  for (std::size_t i = 0; i < line.size(); ++i)
    line[i] = 0.1 * static_cast<double>(i * 97 % 255) * Vec3{1, 1, 0};
  line[9] = {0, 1000, 0};
  triangles_of(line);
}

TEST(Orientation, IsExact) {
  // Points of the line y = x, off it by one step of the last digit.
  for (const double x : {0.1, 0.3, 12.7, 1e6 + 0.3}) {
    const double up = std::nextafter(x, 1e9);
    EXPECT_EQ(orientation({0.5, 0.5}, {24, 24}, {x, x}), 0);
    EXPECT_EQ(orientation({0.5, 0.5}, {24, 24}, {x, up}), 1);
    EXPECT_EQ(orientation({0.5, 0.5}, {24, 24}, {up, x}), -1);
    EXPECT_EQ(orientation({24, 24}, {x, up}, {0.5, 0.5}), 1);
  }
}

}  // namespace
}  // namespace deltamesh::triangulate_test
