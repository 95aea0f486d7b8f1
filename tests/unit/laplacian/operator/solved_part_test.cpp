// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/operator/solved_part.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "support/graph_mesh.h"

namespace deltamesh {
namespace {

using test::GraphMesh;

TEST(SolvedPart, LeavesSmallComponentsOut) {
  const GraphMesh mesh = test::fragments();
  const SolvedPart part = extract_solved_part(mesh.graph, mesh.components);
  ASSERT_EQ(part.vertices.size(), 63U + 8U);
  ASSERT_EQ(part.row_count, 63U + 8U);
  EXPECT_FALSE(part.is_whole());
  EXPECT_FALSE(part.vertices.row_of(63));
  const Components components = find_components(part.graph);
  EXPECT_EQ(part.components.count, components.count);
  EXPECT_EQ(part.components.label, components.label);
  EXPECT_EQ(part.components.size, components.size);
  for (std::uint32_t row = 0; row < part.vertices.size(); ++row) {
    EXPECT_EQ(part.vertices.row_of(part.vertex(row)), row);
    ASSERT_EQ(part.graph.degree(row), mesh.graph.degree(part.vertex(row)));
    for (std::size_t k = 0; k < part.graph.of(row).size(); ++k)
      EXPECT_EQ(part.vertex(part.graph.of(row)[k]), mesh.graph.of(part.vertex(row))[k]);
  }
}

TEST(SolvedPart, IsTheWholeGraphWhereNothingIsSmall) {
  const GraphMesh mesh = test::sheet(5, 4);
  const SolvedPart part = extract_solved_part(mesh.graph, mesh.components);
  EXPECT_TRUE(part.is_whole());
  EXPECT_EQ(part.vertices.runs().size(), 1U);
  EXPECT_EQ(part.vertex(7), 7U);
  EXPECT_EQ(part.vertices.row_of(7), 7U);
  EXPECT_EQ(part.graph.neighbors, mesh.graph.neighbors);
}

}  // namespace
}  // namespace deltamesh
