// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/operator/delta.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/graph_mesh.h"

namespace deltamesh {
namespace {

using test::GraphMesh;

TEST(Delta, IsTheOffsetFromTheMeanOfTheNeighbours) {
  const GraphMesh mesh =
      test::finish({.positions = {{0, 0, 0}, {2, 0, 0}, {0, 4, 0}, {9, 9, 9}}, .triangles = {0, 1, 2}});
  const std::vector<Vec3> deltas = delta_coordinates(mesh.graph, mesh.positions);
  EXPECT_EQ(deltas[0], (Vec3{-1, -2, 0}));
  EXPECT_EQ(deltas[1], (Vec3{2, -2, 0}));
  EXPECT_EQ(deltas[2], (Vec3{-1, 4, 0}));
  EXPECT_EQ(deltas[3], (Vec3{0, 0, 0}));
  EXPECT_EQ(delta_range(deltas), 6);
  EXPECT_EQ(delta_range({}), 0);
}

}  // namespace
}  // namespace deltamesh
