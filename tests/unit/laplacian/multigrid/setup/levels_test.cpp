// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid/setup/levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "laplacian/multigrid/setup/aggregates.h"
#include "laplacian/multigrid/setup/make_interpolation.h"
#include "support/graph_mesh.h"

namespace deltamesh {
namespace {

using test::GraphMesh;

bool is_seed(const multigrid::Aggregates& aggregates, std::uint32_t node) {
  return aggregates.codes[node] >= multigrid::Aggregates::kSeed;
}

TEST(Levels, LevelsShrinkAndKeepTheirAnchorsApart) {
  const GraphMesh mesh = test::sheet(60, 60);
  const auto anchors = test::anchors_of(mesh, 20);
  const auto levels = multigrid::build_levels(mesh.graph, anchors);
  ASSERT_EQ(levels.size(), 4U);
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const multigrid::Level& level = levels[l];
    EXPECT_EQ(std::set<std::uint32_t>(level.anchors.begin(), level.anchors.end()).size(), anchors.size());
    if (l + 1 == levels.size()) break;
    EXPECT_LT(levels[l + 1].node_count() * 2, level.node_count());
    for (const multigrid::Interpolation& p : level.interpolation) {
      EXPECT_EQ(p.weight(0) + p.weight(1) + p.weight(2), 1);
      for (const std::uint32_t node : {p.node(0), p.node(1), p.node(2)})
        EXPECT_LT(node, levels[l + 1].node_count());
    }
    for (std::size_t a = 0; a < anchors.size(); ++a) {
      EXPECT_EQ(level.interpolation[level.anchors[a]].node(0), levels[l + 1].anchors[a]);
      EXPECT_EQ(level.interpolation[level.anchors[a]].weight(0), 1);
    }
  }
}

TEST(Levels, DELT7WeightsAreSumsOverThePathsBetweenSeeds) {
  const GraphMesh mesh = test::sheet(60, 60);
  const auto anchors = test::anchors_of(mesh, 20);
  const auto levels = multigrid::build_levels(mesh.graph, anchors);
  const multigrid::Aggregates aggregates = multigrid::aggregate(levels[0]);
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> expected;
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
    for (const std::uint32_t j : mesh.graph.of(i)) {
      const int seeds = (is_seed(aggregates, i) ? 1 : 0) + (is_seed(aggregates, j) ? 1 : 0);
      if (aggregates.of(i) != aggregates.of(j))
        expected[{aggregates.of(i), aggregates.of(j)}] += seeds == 0 ? 0.4 : seeds == 1 ? 0.6 : 1.2;
    }
  }
  const multigrid::Level& level = levels[1];
  EXPECT_EQ(level.neighbors.size(), expected.size());
  for (std::uint32_t c = 0; c < level.node_count(); ++c) {
    double degree = 0;
    for (std::uint32_t e = level.offsets[c]; e < level.offsets[c + 1]; ++e) {
      EXPECT_NEAR(level.weights[e], (expected[{c, level.neighbors[e]}]), 1e-5);
      EXPECT_EQ(level.neighbors[e] < c, e < level.middle[c]);
      degree += level.weights[e];
    }
    EXPECT_NEAR(degree, level.degree[c], 1e-5);
  }
}

/// P^T K P, dense.
TEST(Levels, DELT7FurtherLevelsAreProducts) {
  const GraphMesh mesh = test::sheet(90, 90);
  const auto anchors = test::anchors_of(mesh, 20);
  const auto levels = multigrid::build_levels(mesh.graph, anchors);
  ASSERT_GE(levels.size(), 4U);
  const multigrid::Level& fine = levels[2];
  const multigrid::Level& coarse = levels[3];
  const std::size_t n = coarse.node_count();
  std::vector<double> expected(n * n, 0.0);
  std::vector<std::uint8_t> has_edge(n * n, 0);
  for (std::uint32_t i = 0; i < fine.node_count(); ++i) {
    const auto add = [&](std::uint32_t j, double k) {
      for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) {
          const double weight = double{fine.interpolation[i].weight(a)} * fine.interpolation[j].weight(b);
          const std::size_t place = fine.interpolation[i].node(a) * n + fine.interpolation[j].node(b);
          expected[place] += k * weight;
          has_edge[place] |= weight > 0 ? 1 : 0;
        }
      }
    };
    add(i, fine.degree[i]);
    for (std::uint32_t e = fine.offsets[i]; e < fine.offsets[i + 1]; ++e)
      add(fine.neighbors[e], -double{fine.weights[e]});
  }
  for (std::uint32_t c = 0; c < n; ++c) {
    EXPECT_NEAR(coarse.degree[c], expected[c * n + c], 1e-4);
    std::size_t edges = 0;
    for (std::size_t other = 0; other < n; ++other) edges += other != c ? has_edge[c * n + other] : 0;
    EXPECT_EQ(coarse.offsets[c + 1] - coarse.offsets[c], edges);
    for (std::uint32_t e = coarse.offsets[c]; e < coarse.offsets[c + 1]; ++e) {
      EXPECT_NEAR(coarse.weights[e], -expected[c * n + coarse.neighbors[e]], 1e-4);
      EXPECT_TRUE(has_edge[c * n + coarse.neighbors[e]]);
    }
  }
}

TEST(Levels, DELT7ThereAreTwoAtLeast) {
  const GraphMesh mesh = test::sheet(40, 40);
  std::vector<std::uint32_t> anchors(400);
  for (std::uint32_t a = 0; a < anchors.size(); ++a) anchors[a] = 2 * a;
  EXPECT_EQ(multigrid::build_levels(mesh.graph, anchors).size(), 2U) << "fewer than five nodes for each";
  anchors.resize(mesh.positions.size());
  for (std::uint32_t a = 0; a < anchors.size(); ++a) anchors[a] = a;
  const auto levels = multigrid::build_levels(mesh.graph, anchors);
  ASSERT_EQ(levels.size(), 2U);
  EXPECT_EQ(levels[1].node_count(), mesh.positions.size());
}

TEST(Levels, DELT7FewNodesAreNotCoarsened) {
  for (const std::uint32_t width : {20U, 19U}) {  // of 200 and 190 nodes
    const GraphMesh mesh = test::sheet(width, 10);
    const std::vector<std::uint32_t> anchors{0};
    EXPECT_EQ(multigrid::build_levels(mesh.graph, anchors).size(), width == 20 ? 2U : 1U);
  }
}

TEST(Levels, DELT7AnchorsAreOnAllLevels) {
  const GraphMesh mesh = test::sheet(80, 80);
  const auto anchors = test::anchors_of(mesh, 30);
  const auto levels = multigrid::build_levels(mesh.graph, anchors);
  EXPECT_LT(levels.back().node_count(), 200U);
  for (std::size_t l = 0; l + 1 < levels.size(); ++l) {
    const multigrid::Level& level = levels[l];
    ASSERT_EQ(levels[l + 1].anchors.size(), anchors.size());
    for (std::size_t a = 0; a < anchors.size(); ++a) {
      const auto& row = level.interpolation[level.anchors[a]];
      EXPECT_EQ(row.weight(0), 1);
      EXPECT_EQ(row.node(0), levels[l + 1].anchors[a]);
    }
  }
}

TEST(Levels, AggregatesAreASeedAndItsNeighbours) {
  const GraphMesh mesh = test::sheet(30, 30);
  const std::uint32_t anchors[] = {5, 6, 700};
  const auto levels = multigrid::build_levels(mesh.graph, anchors);
  const multigrid::Aggregates aggregates = multigrid::aggregate(levels.front());
  for (const std::uint32_t anchor : anchors) EXPECT_TRUE(is_seed(aggregates, anchor));
  std::uint32_t last_seed = 0;
  std::size_t members = 0;
  for (std::uint32_t c = 0; c < aggregates.count(); ++c) {
    const std::uint32_t seed = aggregates.members_of(c).front();
    EXPECT_TRUE(is_seed(aggregates, seed));
    EXPECT_TRUE(c == 0 || seed > last_seed);
    last_seed = seed;
    members += aggregates.members_of(c).size();
    for (const std::uint32_t v : aggregates.members_of(c)) {
      EXPECT_EQ(aggregates.of(v), c);
      const auto neighbors = mesh.graph.of(v);
      EXPECT_TRUE(seed == v || std::binary_search(neighbors.begin(), neighbors.end(), seed));
    }
  }
  EXPECT_EQ(members, mesh.positions.size());
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    for (const std::uint32_t other : mesh.graph.of(v)) {
      if (!is_seed(aggregates, v) && is_seed(aggregates, other)) {
        EXPECT_LE(aggregates.of(v), aggregates.of(other)) << "the lowest seed";
      }
    }
  }
}

/// Of nodes with few neighbours, and of one with ten; the lower aggregates among equals.
TEST(Levels, NodesAreInterpolatedFromTheAggregatesNextToThem) {
  GraphMesh mesh = test::sheet(30, 30);
  mesh.triangles.insert(mesh.triangles.end(), {435, 438, 439, 435, 440, 441});
  mesh = test::finish(std::move(mesh));
  ASSERT_EQ(mesh.graph.degree(435), 10U);
  const std::uint32_t anchors[] = {5, 700};
  const auto levels = multigrid::build_levels(mesh.graph, anchors);
  const multigrid::Aggregates aggregates = multigrid::aggregate(levels.front());
  ASSERT_FALSE(is_seed(aggregates, 435));
  const auto interpolation = multigrid::make_interpolation(levels.front(), aggregates);
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    std::map<std::uint32_t, int> weights;
    for (const std::uint32_t other : mesh.graph.of(v))
      weights[aggregates.of(other)] += is_seed(aggregates, other) ? 4 : 1;
    if (is_seed(aggregates, v)) weights = {{aggregates.of(v), 1}};
    std::vector<std::pair<std::uint32_t, int>> heaviest(weights.begin(), weights.end());
    std::stable_sort(heaviest.begin(), heaviest.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    heaviest.resize(3);
    const auto sum = static_cast<float>(heaviest[0].second + heaviest[1].second + heaviest[2].second);
    for (std::size_t k = 0; k < 3; ++k) {
      const float sixteenths = 16 * static_cast<float>(heaviest[k].second) / sum;
      if (k > 0) {
        EXPECT_EQ(16 * interpolation[v].weight(k), std::floor(sixteenths + 0.5F)) << v;
      }
      if (interpolation[v].weight(k) > 0) {
        EXPECT_EQ(interpolation[v].node(k), heaviest[k].first) << v;
      }
    }
  }
}

}  // namespace
}  // namespace deltamesh
