// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "laplacian/anchors/anchor_sequence.h"
#include "support/graph_mesh.h"

namespace deltamesh {
namespace {

using test::GraphMesh;

/// Hop distance to the nearest anchor by plain relaxation until nothing changes; 1000 where none is reached.
std::vector<std::uint32_t> hops_by_relaxation(const Adjacency& graph,
                                              const std::vector<std::uint32_t>& anchors) {
  std::vector<std::uint32_t> hops(graph.vertex_count(), 1000);
  for (const std::uint32_t anchor : anchors) hops[anchor] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::uint32_t v = 0; v < hops.size(); ++v) {
      for (const std::uint32_t w : graph.of(v)) {
        if (hops[v] <= hops[w] + 1) continue;
        hops[v] = hops[w] + 1;
        changed = true;
      }
    }
  }
  return hops;
}

TEST(Anchors, CountIsMetAndCoverageIsTheReportedDensity) {
  const GraphMesh mesh = test::sheet(30, 20);
  AnchorSequence sequence(mesh.graph, mesh.components);
  for (const std::uint32_t count : {1U, 2U, 7U, 60U}) {
    const Anchors anchors = sequence.first(mesh.graph, count);
    EXPECT_EQ(anchors.vertices.size(), count);
    EXPECT_TRUE(std::is_sorted(anchors.vertices.begin(), anchors.vertices.end()));
    const auto hops = hops_by_relaxation(mesh.graph, anchors.vertices);
    EXPECT_EQ(*std::max_element(hops.begin(), hops.end()), anchors.density);
  }
}

TEST(Anchors, DensityIsMet) {
  const GraphMesh mesh = test::sheet(30, 20);
  AnchorSequence sequence(mesh.graph, mesh.components);
  std::size_t fewer = 0;
  for (const std::uint32_t density : {15U, 8U, 3U, 1U}) {
    const Anchors anchors = sequence.first(mesh.graph, sequence.count_for_density(mesh.graph, density));
    const auto hops = hops_by_relaxation(mesh.graph, anchors.vertices);
    EXPECT_LE(*std::max_element(hops.begin(), hops.end()), density);
    EXPECT_LE(anchors.density, density);
    EXPECT_GT(anchors.vertices.size(), fewer);
    fewer = anchors.vertices.size();
  }
}

TEST(Anchors, NoMoreThanThereAreVertices) {
  const GraphMesh mesh = test::sheet(4, 3);
  const Anchors anchors = AnchorSequence(mesh.graph, mesh.components).first(mesh.graph, 1000000);
  EXPECT_EQ(anchors.vertices.size(), 12U);
  EXPECT_EQ(anchors.density, 0U);
}

TEST(Anchors, ANCH2CoverEveryComponentAndAllOfSmallOnes) {
  const GraphMesh mesh = test::fragments();
  const std::vector<std::uint32_t> anchors = test::anchors_of(mesh, 0);
  std::vector<std::uint32_t> in_component(mesh.components.count, 0);
  for (const std::uint32_t anchor : anchors) ++in_component[mesh.components.label[anchor]];
  for (std::uint32_t c = 0; c < mesh.components.count; ++c)
    EXPECT_EQ(in_component[c], mesh.components.size[c] < 8 ? mesh.components.size[c] : 1U);
  EXPECT_EQ(test::anchors_of(mesh, 5).size(), 8U + 5U);
}

}  // namespace
}  // namespace deltamesh
