// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/part_solver.h"

#include <gtest/gtest.h>

#include "geometry/highpass.h"
#include "laplacian/anchors.h"
#include "laplacian/delta.h"
#include "support/graph_mesh.h"

namespace deltamesh {
namespace {

/// A decoder solves once, an encoder many times with one set-up: the answers must be the same to the last
/// bit.
TEST(PartSolver, AnswersDoNotDependOnEarlierOnes) {
  for (const auto& mesh : {test::sheet(90, 70), test::fragments(), test::fan(300)}) {
    const SolvedPart part = extract_solved_part(mesh.graph, mesh.components);
    std::vector<std::uint32_t> anchors;
    for (const std::uint32_t vertex : place_anchors(mesh.graph, mesh.components, {.count = 12}).vertices)
      if (part.rows[vertex] != SolvedPart::kNoRow) anchors.push_back(part.rows[vertex]);
    std::vector<Vec3> positions;
    for (const std::uint32_t vertex : part.vertices) positions.push_back(mesh.positions[vertex]);
    std::vector<Vec3> targets;
    for (const std::uint32_t anchor : anchors) targets.push_back(positions[anchor]);
    const std::vector<Vec3> fine = delta_coordinates(part.graph, positions);
    std::vector<Vec3> coarse = fine;
    for (Vec3& delta : coarse)
      for (double& x : delta) x = std::round(4 * x) / 4;

    std::vector<Vec3> first(positions.size());
    std::vector<Vec3> other(positions.size());
    std::vector<Vec3> again(positions.size());
    PartSolver solver(part);
    ASSERT_TRUE(solver.solve(anchors, coarse, targets, first));
    ASSERT_TRUE(solver.solve(anchors, fine, targets, other));
    ASSERT_TRUE(solver.solve(anchors, coarse, targets, again));
    EXPECT_EQ(first, again);
    EXPECT_NE(first, other);
    PartSolver fresh(part);
    ASSERT_TRUE(fresh.solve(anchors, fine, targets, again));
    EXPECT_EQ(other, again);
  }
}

TEST(HighpassCoder, SettingsDoNotDependOnEarlierOnes) {
  const auto mesh = test::sheet(80, 60);
  HighpassCoder coder(mesh.graph, mesh.components, mesh.positions, mesh.box);
  HighpassSettings settings{.step = 0.1, .rate_weight = 0.12, .diffusion = 0.8, .centroids = true};
  settings.anchors = place_anchors(mesh.graph, mesh.components, {.count = 20});
  ASSERT_TRUE(coder.code({.step = 0.01, .anchors = settings.anchors}));
  const auto coded = coder.code(settings);
  ASSERT_TRUE(coded);
  EXPECT_NE(coded->parameters.shift, ReconstructionShift{});
  const auto read =
      read_highpass(coded->deltas, coded->anchors, mesh.graph, mesh.components, mesh.box, coded->parameters);
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, coded->positions);
  const auto bytes_alone = coder.code_only(settings);
  ASSERT_TRUE(bytes_alone);
  EXPECT_EQ(bytes_alone->deltas, coded->deltas);
  EXPECT_EQ(bytes_alone->anchors, coded->anchors);
}

}  // namespace
}  // namespace deltamesh
