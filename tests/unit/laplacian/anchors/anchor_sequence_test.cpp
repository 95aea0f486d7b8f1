// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/anchors/anchor_sequence.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/graph_mesh.h"

namespace deltamesh {
namespace {

TEST(AnchorSequence, EveryContainerKeepsItsDensity) {
  const auto mesh = test::sheet(40, 30);
  AnchorSequence sequence(mesh.graph, mesh.components);
  std::uint32_t previous = 0;
  for (std::uint32_t v = 15; v >= 5; --v) {
    const std::uint32_t count = sequence.count_for_density(mesh.graph, v);
    EXPECT_GE(count, previous);
    const Anchors anchors = sequence.first(mesh.graph, count);
    EXPECT_EQ(anchors.vertices.size(), count);
    EXPECT_LE(anchors.density, v);
    EXPECT_EQ(anchors.density, hop_density(mesh.graph, anchors.vertices));
    if (count > sequence.fewest()) {
      EXPECT_GT(sequence.density(mesh.graph, count - 1), v);
    }
    previous = count;
  }
}

TEST(AnchorSequence, NeverSearchesTwice) {
  const auto mesh = test::sheet(40, 30);
  AnchorSequence sequence(mesh.graph, mesh.components);
  const std::uint32_t fine = sequence.count_for_density(mesh.graph, 5);
  const auto searches = sequence.searches();
  for (std::uint32_t v = 5; v <= 15; ++v) EXPECT_LE(sequence.count_for_density(mesh.graph, v), fine);
  EXPECT_EQ(sequence.first(mesh.graph, fine / 2).vertices.size(), fine / 2);
  EXPECT_EQ(sequence.searches(), searches);
}

TEST(AnchorSequence, OrderOfQuestionsDoesNotMatter) {
  const auto mesh = test::fragments();
  AnchorSequence forth(mesh.graph, mesh.components);
  AnchorSequence back(mesh.graph, mesh.components);
  std::vector<Anchors> rising;
  for (std::uint32_t count = 0; count <= 80; ++count) rising.push_back(forth.first(mesh.graph, count));
  for (std::uint32_t count = 81; count-- > 0;) {
    const Anchors anchors = back.first(mesh.graph, count);
    EXPECT_EQ(anchors.vertices, rising[count].vertices);
    EXPECT_EQ(anchors.density, rising[count].density);
  }
}

TEST(AnchorSequence, HasOneInEverySolvedComponentAndAllOfTheSmall) {
  const auto mesh = test::fragments();  // sheets of 63 and 8 vertices; 8 vertices in small components
  AnchorSequence sequence(mesh.graph, mesh.components);
  EXPECT_EQ(sequence.fewest(), 2U);
  EXPECT_EQ(sequence.most(), 71U);
  EXPECT_EQ(sequence.first(mesh.graph, 0).vertices.size(), 2U + 8U);
  const Anchors all = sequence.first(mesh.graph, 1000);
  EXPECT_EQ(all.vertices.size(), mesh.positions.size());
  EXPECT_EQ(all.density, 0U);
}

TEST(AnchorSequence, EmptyGraph) {
  const auto mesh = test::finish({});
  AnchorSequence sequence(mesh.graph, mesh.components);
  EXPECT_EQ(sequence.first(mesh.graph, 5).vertices.size(), 0U);
  EXPECT_EQ(sequence.count_for_density(mesh.graph, 3), 0U);
}

TEST(AnchorContainers, AreKeptForTheSameGraphOnly) {
  const auto mesh = test::sheet(20, 20);
  const auto other = test::sheet(21, 20);
  AnchorContainers containers;
  EXPECT_EQ(containers.searches(), 0U);
  containers.impl().sequence(mesh.graph, mesh.components).first(mesh.graph, 30);
  const auto searches = containers.searches();
  EXPECT_GE(searches, 30U);
  containers.impl().sequence(mesh.graph, mesh.components).first(mesh.graph, 20);
  EXPECT_EQ(containers.searches(), searches);
  AnchorSequence fresh(other.graph, other.components);
  EXPECT_EQ(containers.impl().sequence(other.graph, other.components).first(other.graph, 20).vertices,
            fresh.first(other.graph, 20).vertices);
}

}  // namespace
}  // namespace deltamesh
