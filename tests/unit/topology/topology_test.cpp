// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "base/threads/thread_team.h"
#include "topology/adjacency.h"
#include "topology/mesh_edges.h"
#include "topology/subgraph.h"
#include "topology/vertex_runs.h"
#include "topology/vertex_subset.h"
#include "topology/weld.h"

namespace deltamesh {
namespace {

using Indices = std::vector<std::uint32_t>;

TEST(Weld, MergesEqualBitsInOrderOfAppearance) {
  const std::vector<float> positions = {1, 2, 3, 4, 5, 6, 1, 2, 3, 4, 5, 6, 0, 0, 0, 1, 2, 3};
  const Weld weld = weld_by_position(positions, std::vector<std::uint8_t>(6, 1));
  EXPECT_EQ(weld.geometric, (Indices{0, 1, 0, 1, 2, 0}));
  EXPECT_EQ(weld.representative, (Indices{0, 1, 4}));
}

TEST(Weld, ComparesBitsNotValues) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<float> positions = {0.0F, 0, 0, -0.0F, 0, 0, nan, 0, 0, nan, 0, 0, 0, 0, 1, 0, 1, 0};
  const Weld weld = weld_by_position(positions, std::vector<std::uint8_t>(6, 1));
  EXPECT_EQ(weld.geometric, (Indices{0, 1, 2, 2, 3, 4}));
}

TEST(Weld, LeavesUnflaggedVerticesAlone) {
  const std::vector<float> positions(5 * 3, 7.0F);
  const Weld weld = weld_by_position(positions, std::vector<std::uint8_t>{0, 1, 0, 1, 0});
  EXPECT_EQ(weld.geometric, (Indices{0, 1, 2, 1, 3}));
  EXPECT_EQ(weld.representative, (Indices{0, 1, 2, 4}));
}

TEST(Weld, EmptyInput) {
  const Weld weld = weld_by_position({}, {});
  EXPECT_TRUE(weld.geometric.empty());
  EXPECT_TRUE(weld.representative.empty());
}

TEST(Weld, RegularGridHasNoFalseMerges) {
  std::vector<float> positions;
  for (int x = 0; x < 30; ++x)
    for (int y = 0; y < 30; ++y)
      for (int z = 0; z < 30; ++z)
        for (const int c : {x, y, z}) positions.push_back(static_cast<float>(c) * 0.05F);
  const std::vector<float> once = positions;
  positions.insert(positions.end(), once.begin(), once.end());
  const Weld weld = weld_by_position(positions, std::vector<std::uint8_t>(54000, 1));
  ASSERT_EQ(weld.representative.size(), 27000U);
  for (std::uint32_t v = 0; v < 27000; ++v) {
    EXPECT_EQ(weld.geometric[v], v);
    EXPECT_EQ(weld.geometric[v + 27000], v);
  }
}

TEST(Adjacency, DegenerateAndDuplicateFaces) {
  const Adjacency graph = build_adjacency(Indices{0, 1, 2, 2, 1, 0, 3, 3, 1, 4, 4, 4}, 6);
  ASSERT_EQ(graph.vertex_count(), 6U);
  EXPECT_EQ(graph.offsets, (LargeVector<std::uint32_t>{0, 2, 5, 7, 8, 8, 8}));
  EXPECT_EQ(graph.neighbors, (LargeVector<std::uint32_t>{1, 2, 0, 2, 3, 0, 1, 1}));
}

TEST(MeshEdges, EveryEdgeOnce) {
  const Indices triangles{0, 1, 2, 2, 1, 0, 3, 3, 1, 4, 4, 4};
  const MeshEdges edges = find_edges(triangles, 6);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> visited;
  edges.for_each([&](std::uint32_t a, std::uint32_t b) { visited.emplace_back(a, b); });
  EXPECT_EQ(visited, (std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0, 1}, {1, 2}, {2, 0}, {3, 1}}));
  EXPECT_EQ(edges.lone_vertices, (std::vector<std::uint32_t>{4, 5}));
}

TEST(Adjacency, EmptyGraph) {
  const Adjacency graph = build_adjacency({}, 0);
  EXPECT_EQ(graph.vertex_count(), 0U);
  EXPECT_EQ(find_components(graph).count, 0U);
}

/// As often as an edge comes more in the one direction than in the other.
std::vector<DirectedEdge> open_edges_of(const Indices& triangles) {
  std::map<DirectedEdge, int> excess;
  for (std::size_t f = 0; f < triangles.size(); f += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[f + k];
      const std::uint32_t b = triangles[f + (k + 1) % 3];
      ++excess[{a, b}];
      --excess[{b, a}];
    }
  }
  std::vector<DirectedEdge> open;
  for (const auto& [edge, count] : excess) open.insert(open.end(), std::max(count, 0), edge);
  return open;
}

TEST(Adjacency, VerticesWithoutEdges) {
  const std::vector<std::uint32_t> points = {1, 1, 1, 2, 2, 2};
  for (const std::vector<std::uint32_t>& triangles : {std::vector<std::uint32_t>(), points}) {
    const Adjacency graph = build_adjacency(triangles, {}, 3);
    EXPECT_EQ(graph.offsets, LargeVector<std::uint32_t>(4, 0));
    EXPECT_TRUE(graph.neighbors.empty());
  }
}

TEST(Adjacency, MatchesSetsOnRandomSoups) {
  std::mt19937 engine(7);
  const auto below = [&](std::uint32_t bound) { return static_cast<std::uint32_t>(engine() % bound); };
  for (std::uint32_t round = 0; round < 50; ++round) {
    const std::uint32_t n = 1 + below(40);
    Indices triangles(3 * std::size_t{below(60)});
    for (std::uint32_t& v : triangles) v = below(n);
    std::vector<std::set<std::uint32_t>> expected(n);
    for (std::size_t f = 0; f < triangles.size(); f += 3) {
      for (std::size_t i = 0; i < 9; ++i) {
        const std::uint32_t a = triangles[f + i / 3];
        const std::uint32_t b = triangles[f + i % 3];
        if (a != b) expected[a].insert(b);
      }
    }
    for (const Adjacency& graph :
         {build_adjacency(triangles, n), build_adjacency(triangles, open_edges_of(triangles), n)}) {
      for (std::uint32_t v = 0; v < n; ++v) {
        EXPECT_EQ(Indices(graph.of(v).begin(), graph.of(v).end()),
                  Indices(expected[v].begin(), expected[v].end()));
      }
    }
  }
}

/// Some vertices have no face, some neighbours come several times, some far away.
TEST(Adjacency, ThreadsFillRowsFromBothEnds) {
  constexpr std::uint32_t kVertices = 50000;
  std::mt19937 engine(11);
  const auto below = [&](std::uint32_t bound) { return static_cast<std::uint32_t>(engine() % bound); };
  Indices triangles;
  for (std::uint32_t v = 0; v < kVertices - 10; v += 1 + below(3)) {
    triangles.insert(triangles.end(), {v, v + below(10), below(50) == 0 ? below(kVertices) : v + below(10)});
  }
  std::vector<DirectedEdge> edges;  // turned round, they make up for all of the faces
  for (std::size_t f = 0; f < triangles.size(); f += 3) {
    for (std::size_t k = 0; k < 3; ++k) edges.push_back({triangles[f + k], triangles[f + (k + 1) % 3]});
  }
  const Adjacency expected = build_adjacency(triangles, kVertices);
  for (const unsigned threads : {1U, 2U, 3U}) {
    ThreadTeam team(threads);
    const Adjacency graph = build_adjacency(triangles, edges, kVertices, &team);
    EXPECT_EQ(graph.offsets, expected.offsets);
    EXPECT_EQ(graph.neighbors, expected.neighbors);
  }
}

TEST(Components, NumberedBySmallestVertex) {
  const Components components = find_components(build_adjacency(Indices{5, 6, 2, 0, 4, 4, 6, 3, 5}, 8));
  EXPECT_EQ(components.count, 4U);
  EXPECT_EQ(components.label, (LargeVector<std::uint32_t>{0, 1, 2, 2, 0, 2, 2, 3}));
  EXPECT_EQ(components.size, (Indices{2, 1, 4, 1}));
}

TEST(VertexRuns, JoinedRunsAreOneComponent) {
  VertexRuns runs;
  EXPECT_EQ(runs.count(0), 0U);
  for (const std::uint32_t first : {0U, 3U, 4U}) runs.begin(first);
  runs.join(2);
  runs.begin(6);  // without vertices, it joins the others
  runs.join(3);
  runs.join(5);
  runs.join(0);  // as it is already
  runs.begin(6);
  runs.end(8);
  EXPECT_EQ(runs.count(10), 4U);
  const Components components = runs.components(10);
  EXPECT_EQ(components.count, 4U);
  EXPECT_EQ(components.label, (LargeVector<std::uint32_t>{0, 0, 0, 0, 0, 0, 1, 1, 2, 3}));
  EXPECT_EQ(components.size, (Indices{6, 2, 1, 1}));
}

VertexSubset subset_of(const std::vector<std::uint32_t>& vertices) {
  VertexSubset subset;
  for (const std::uint32_t vertex : vertices) subset.append(vertex, vertex + 1);
  return subset;
}

TEST(VertexSubset, FindsRowsAndVertices) {
  const std::vector<std::uint32_t> vertices = {1, 2, 3, 7, 9, 10};
  const VertexSubset subset = subset_of(vertices);
  EXPECT_EQ(subset.runs().size(), 3U);
  ASSERT_EQ(subset.size(), vertices.size());
  SubsetCursor cursor(subset);
  for (std::uint32_t vertex = 0; vertex < 12; ++vertex) {
    const auto found = std::find(vertices.begin(), vertices.end(), vertex);
    const auto row = subset.row_of(vertex);
    EXPECT_EQ(cursor.row_of(vertex), row);
    EXPECT_EQ(cursor.row_of(vertex), row);
    ASSERT_EQ(row.has_value(), found != vertices.end()) << vertex;
    if (!row) continue;
    EXPECT_EQ(*row, found - vertices.begin());
    EXPECT_EQ(subset.vertex(*row), vertex);
  }
  EXPECT_FALSE(VertexSubset().row_of(0));
  EXPECT_EQ(VertexSubset().size(), 0U);
}

TEST(VertexSubset, MovesRows) {
  const VertexSubset subset = subset_of({0, 1, 4, 5, 7});
  const Indices rows = {10, 11, 14, 15, 17};
  Indices scattered(8, 0);
  scatter_rows(std::span<const std::uint32_t>(rows), subset, std::span(scattered));
  EXPECT_EQ(scattered, (Indices{10, 11, 0, 0, 14, 15, 0, 17}));
  Indices values = rows;
  values.resize(8);
  spread_rows(subset, std::span(values));
  for (const std::uint32_t vertex : {0U, 1U, 4U, 5U, 7U}) EXPECT_EQ(values[vertex], 10 + vertex);
}

TEST(Subgraph, VisitsRunsOfComponents) {
  const Components components{.count = 4, .label = {0, 0, 1, 1, 1, 0, 2, 3, 3}, .size = {3, 3, 1, 2}};
  std::vector<Indices> runs;
  const auto add = [&](std::uint32_t begin, std::uint32_t end, std::uint32_t component) {
    runs.push_back({begin, end, component});
  };
  for_each_run(components, add);
  EXPECT_EQ(runs, (std::vector<Indices>{{0, 2, 0}, {2, 5, 1}, {5, 6, 0}, {6, 7, 2}, {7, 9, 3}}));
  runs.clear();
  for_each_run(components, 1, 4, add);
  EXPECT_EQ(runs, (std::vector<Indices>{{1, 2, 0}, {2, 4, 1}}));
}

TEST(Subgraph, KeepsWholeComponents) {
  const Adjacency graph = build_adjacency(Indices{5, 6, 2, 0, 4, 4, 6, 3, 5, 1, 7, 8}, 9);
  const std::vector<std::uint32_t> kept = {1, 2, 3, 5, 6, 7, 8};
  const Adjacency copy = copy_vertices(graph, subset_of(kept));
  ASSERT_EQ(copy.vertex_count(), kept.size());
  for (std::uint32_t i = 0; i < kept.size(); ++i) {
    ASSERT_EQ(copy.degree(i), graph.degree(kept[i]));
    for (std::size_t k = 0; k < copy.of(i).size(); ++k) EXPECT_EQ(kept[copy.of(i)[k]], graph.of(kept[i])[k]);
  }
  Adjacency same = graph;
  keep_vertices(same, subset_of(kept));
  EXPECT_EQ(same.offsets, copy.offsets);
  EXPECT_EQ(same.neighbors, copy.neighbors);
  const Components components = pick_components(find_components(graph), subset_of(kept));
  EXPECT_EQ(components.label, find_components(copy).label);
  EXPECT_EQ(components.size, find_components(copy).size);
  EXPECT_EQ(components.count, 2U);
  keep_vertices(same, {});
  EXPECT_EQ(same.vertex_count(), 0U);
  EXPECT_TRUE(same.neighbors.empty());
}

}  // namespace
}  // namespace deltamesh
