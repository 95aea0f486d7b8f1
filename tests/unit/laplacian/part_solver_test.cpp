// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/part_solver.h"

#include <gtest/gtest.h>

#include <string_view>

#include "geometry/highpass.h"
#include "laplacian/multigrid/setup/levels.h"
#include "laplacian/operator/delta.h"
#include "support/graph_mesh.h"

namespace deltamesh {
namespace {

using test::GraphMesh;

/// Without them there are no planned cycles [DELT-7].
bool has_levels(const Adjacency& graph, const std::vector<std::uint32_t>& anchors) {
  return multigrid::build_levels(graph, anchors).size() > 1;
}

/// As around the hub of a fan: encoders do not plan such cycles [DELT-7].
bool leaves_range(const Result<void>& solved) {
  return !solved && std::string_view(solved.error().rule) == "DELT-7";
}

/// A decoder solves once, an encoder many times with one set-up: the answers must be the same to the last
/// bit.
TEST(PartSolver, AnswersDoNotDependOnEarlierOnes) {
  for (const auto& mesh : {test::sheet(90, 70), test::fragments(), test::fan(300)}) {
    const SolvedPart part = extract_solved_part(mesh.graph, mesh.components);
    std::vector<std::uint32_t> anchors;
    for (const std::uint32_t vertex : test::anchors_of(mesh, 12))
      if (const auto row = part.row_of(vertex)) anchors.push_back(*row);
    std::vector<Vec3> positions;
    for (std::size_t row = 0; row < part.row_count; ++row)
      positions.push_back(mesh.positions[part.vertex(row)]);
    std::vector<Vec3> targets;
    for (const std::uint32_t anchor : anchors) targets.push_back(positions[anchor]);
    const std::vector<Vec3> fine = delta_coordinates(part.graph, positions);
    std::vector<Vec3> coarse = fine;
    for (Vec3& delta : coarse)
      for (double& x : delta) x = std::round(4 * x) / 4;

    std::vector<Vec3> first(positions.size());
    std::vector<Vec3> other(positions.size());
    std::vector<Vec3> again(positions.size());
    for (const int cycles : {0, 2}) {
      if (cycles > 0 && !has_levels(part.graph, anchors)) continue;
      PartSolver solver(part);
      const auto solved = solver.solve(anchors, coarse, targets, cycles, first);
      if (leaves_range(solved)) continue;
      ASSERT_TRUE(solved);
      ASSERT_TRUE(solver.solve(anchors, fine, targets, cycles, other));
      ASSERT_TRUE(solver.solve(anchors, coarse, targets, cycles, again));
      EXPECT_EQ(first, again);
      EXPECT_NE(first, other);
      PartSolver fresh(part);
      ASSERT_TRUE(fresh.solve(anchors, fine, targets, cycles, again));
      EXPECT_EQ(other, again);
    }
  }
}

TEST(HighpassCoder, SettingsDoNotDependOnEarlierOnes) {
  const auto mesh = test::sheet(80, 60);
  AnchorSequence anchors(mesh.graph, mesh.components);
  HighpassCoder coder(mesh.graph, mesh.components, anchors, mesh.positions, mesh.box);
  const HighpassSettings settings{
      .step = 0.1, .rate_weight = 0.12, .centroids = true, .diffusion = 0.8, .anchors = 20};
  ASSERT_TRUE(coder.code({.step = 0.01, .anchors = 20}));
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
