// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Levels of pairs: every mesh ends in one node after few levels, the same ones whoever makes them.
#include "attributes/haar/levels/levels.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <thread>
#include <vector>

#include "attributes/haar/levels/pairing.h"
#include "attributes/haar/levels/places.h"
#include "attributes/haar/log_class.h"
#include "haar/meshes.h"

namespace deltamesh::haar_test {
namespace {

constexpr std::uint32_t kNone = HaarChildren::kNone;

/// Every node has one parent, weights add up, and all is of linear size.
void check_levels(const std::vector<HaarLevel>& levels, std::uint32_t vertices) {
  ASSERT_FALSE(levels.empty());
  ASSERT_EQ(levels[0].nodes.size(), vertices);
  EXPECT_LE(levels.back().nodes.size(), 1U);
  std::size_t all = 0;
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const HaarLevel& level = levels[l];
    all += level.nodes.size();
    std::uint64_t weight = 0;
    for (const HaarNode& node : level.nodes) weight += node.weight;
    EXPECT_EQ(weight, vertices);
    for (std::uint32_t i = 0; i < level.nodes.size(); ++i) {
      EXPECT_LE(level.graph.degree(i), kMostHaarNeighbors);
      for (const std::uint32_t j : level.graph.of(i)) EXPECT_TRUE(j != i && j < level.nodes.size());
    }
    if (l == 0) continue;
    const std::size_t finer = levels[l - 1].nodes.size();
    EXPECT_LE(level.nodes.size(), finer * 3 / 4 + 1);
    EXPECT_LT(level.nodes.size(), finer);
    std::vector<int> parents(finer);
    for (const HaarChildren& children : level.children) {
      ++parents[children.first];
      if (children.second != kNone) ++parents[children.second];
    }
    for (const int count : parents) EXPECT_EQ(count, 1);
  }
  EXPECT_LE(all, std::size_t{4} * vertices + levels.size());
}

std::vector<HaarLevel> levels_of(const Colored& mesh) {
  auto levels = make_haar_levels(mesh.surface());
  check_levels(levels, mesh.count);
  return levels;
}

bool equal(const std::vector<HaarLevel>& a, const std::vector<HaarLevel>& b) {
  bool same = a.size() == b.size();
  for (std::size_t l = 0; same && l < a.size(); ++l) {
    same = a[l].nodes.size() == b[l].nodes.size() && a[l].children.size() == b[l].children.size();
    for (std::size_t i = 0; same && i < a[l].nodes.size(); ++i)
      same = a[l].nodes[i].place == b[l].nodes[i].place && a[l].nodes[i].weight == b[l].nodes[i].weight;
    for (std::size_t i = 0; same && i < a[l].children.size(); ++i)
      same = a[l].children[i].first == b[l].children[i].first &&
             a[l].children[i].second == b[l].children[i].second;
  }
  return same;
}

TEST(HaarLevels, HAAR1LogarithmsOfWholeNumbers) {
  EXPECT_EQ(log_class<2>(1U), 0U);
  EXPECT_EQ(log_class<2>(3U), 6U);
  EXPECT_EQ(log_class<4>(2U), 16U);
  EXPECT_EQ(log_class<4>(33U), 16U * 5);
  EXPECT_EQ(log_class<4>(34U), 16U * 5 + 1);
  EXPECT_EQ(log_class<8>(1000U), 256U * 9 + (1000U - 512) / 2);
  EXPECT_EQ(log_class<8>(std::numeric_limits<std::uint64_t>::max()), 256U * 64 - 1);
  for (std::uint64_t x = 1; x < std::uint64_t{1} << 53; x = x * 9 / 8 + 1)
    EXPECT_EQ(log_class<8>(x), log_class<8>(static_cast<double>(x))) << x;
}

TEST(HaarLevels, HAAR2PlacesFillTheRangeWhateverThePositions) {
  const std::vector<float> corners = {-1, 5, 0, 1, 5, 0.5F};
  const auto places = make_haar_places(corners, 2);
  EXPECT_EQ(places[0], (HaarPlace{0, 0, 0}));
  EXPECT_EQ(places[1], (HaarPlace{1 << 19, 0, 1 << 17}));
  constexpr float kHuge = std::numeric_limits<float>::max();
  constexpr float kTiny = std::numeric_limits<float>::denorm_min();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const float size : {kHuge, kTiny, 1.0F, 3.1e-20F}) {
    const std::vector<float> positions = {-size, 0, size, size, kNan, kInfinity, 0, size, -kInfinity};
    const auto found = make_haar_places(positions, 3);
    for (const HaarPlace& place : found)
      for (const std::int32_t x : place) EXPECT_TRUE(x >= 0 && x < 1 << kHaarPlaceBits);
    EXPECT_GE(found[1][0], 1 << 19);
    EXPECT_EQ(found[1][1], 0);
  }
  EXPECT_EQ(make_haar_places({}, 3)[2], HaarPlace{});
}

TEST(HaarLevels, HAAR3NoVertexAndOneVertex) {
  EXPECT_EQ(levels_of(points({})).size(), 1U);
  const auto levels = levels_of(points({1, 2, 3}));
  ASSERT_EQ(levels.size(), 1U);
  EXPECT_EQ(levels[0].nodes[0].weight, 1U);
}

TEST(HaarLevels, HAAR3CopiesAreJoinedFirst) {
  // A pair of copies in the middle of a strip whose other vertices are near each other.
  Colored mesh = points({0, 0, 0, 1, 0, 0, 1, 0, 0, 2, 0, 0});
  mesh.triangles = {0, 1, 1, 2, 3, 3};
  mesh.geometric = {0, 1, 1, 2};
  EXPECT_EQ(levels_of(mesh)[1].children[1].second, 2U);
}

TEST(HaarLevels, HAAR4NearAndLightNodesAreJoinedFirst) {
  // 0 - 1 - 2 - 3 - 4 with gaps of 4, 1, 2, 1: mutual choices are 1-2 and 3-4.
  Colored mesh = points({0, 0, 0, 4, 0, 0, 5, 0, 0, 7, 0, 0, 8, 0, 0});
  mesh.triangles = {0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4};
  HaarLevel level = levels_of(mesh)[0];
  const auto mates = pair_nodes(level);
  EXPECT_EQ(std::vector<std::uint32_t>(mates.begin(), mates.end()),
            (std::vector<std::uint32_t>{0, 2, 1, 4, 3}));
  level.nodes[4].weight = 100;  // then 3 costs less with 2
  level.nodes[1].weight = 100;
  const auto others = pair_nodes(level);
  EXPECT_EQ(others[2], 3U);
}

TEST(HaarLevels, HAAR4NeighboursOfOneNodeAreJoinedToo) {
  // Without that a star would take as many levels as it has rays.
  Colored star = points(std::vector<float>(3 * 2001));
  for (std::uint32_t i = 1; i <= 2000; ++i) {
    star.triangles.insert(star.triangles.end(), {0, i, i});
    star.positions[3 * i] = static_cast<float>(i);
  }
  EXPECT_LT(levels_of(star).size(), 40U);
}

TEST(HaarLevels, HAAR4IsolatedNodesAreJoinedAlongACurve) {
  // Two far groups of points, each in one half of the curve.
  std::vector<float> positions;
  for (int i = 0; i < 8; ++i)
    for (const float x : {(i % 2 == 0 ? 0.0F : 100.0F) + static_cast<float>(i), 0.0F, 0.0F})
      positions.push_back(x);
  const auto levels = levels_of(points(positions));
  for (const HaarChildren& children : levels[1].children) EXPECT_EQ(children.first % 2, children.second % 2);
  EXPECT_EQ(levels.size(), 4U);
}

TEST(HaarLevels, HAAR5PlacesAreMeansByWeight) {
  Colored mesh = points({0, 0, 0, 1, 0, 0, 4, 0, 0});
  mesh.triangles = {0, 1, 2};
  const auto levels = levels_of(mesh);
  ASSERT_EQ(levels.size(), 3U);
  const std::int32_t unit = levels[0].nodes[1].place[0];
  EXPECT_EQ(levels[1].nodes[0].place[0], unit / 2);
  EXPECT_EQ(levels[2].nodes[0].weight, 3U);
  EXPECT_NEAR(levels[2].nodes[0].place[0], unit * 5 / 3, unit / 100);
  EXPECT_EQ(levels[2].children[0].share_of_first, 43690U);
}

TEST(HaarLevels, HAAR5EveryMeshEndsInOneNode) {
  for (const Scene scene : {Scene::kRooms, Scene::kTerrain, Scene::kCad, Scene::kFragments}) {
    const Mesh mesh = *generate_scene(scene, 3000, 1);
    Colored bare = points(mesh.positions);
    bare.triangles = mesh.triangles;
    levels_of(bare);
    bare.positions.clear();
    levels_of(bare);
  }
  levels_of(points(std::vector<float>(3 * 1000, 7)));  // all in one place
  levels_of(colored(test::fan(5000)));
}

TEST(HaarLevels, ThreadsMakeTheSame) {
  const Colored mesh = rooms(4000, 2);
  const auto levels = levels_of(mesh);
  std::array<bool, 4> same{};
  std::vector<std::thread> threads;
  for (bool& is_same : same)
    threads.emplace_back([&] { is_same = equal(make_haar_levels(mesh.surface()), levels); });
  for (std::thread& thread : threads) thread.join();
  for (const bool is_same : same) EXPECT_TRUE(is_same);
}

}  // namespace
}  // namespace deltamesh::haar_test
