// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "measure/measure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/graph_mesh.h"

namespace deltamesh {
namespace {

using test::GraphMesh;

TEST(Quality, EqualMeshesHaveNoError) {
  const GraphMesh mesh = test::fragments();
  const Quality quality = measure_quality(mesh.graph, mesh.positions, mesh.positions);
  EXPECT_EQ(quality.vde_rms, 0);
  EXPECT_EQ(quality.lfe_rms, 0);
  EXPECT_EQ(quality.max_error, 0);
}

TEST(Quality, QUAL2ATranslationIsPositionalOnly) {
  const GraphMesh mesh = test::sheet(20, 20);
  std::vector<Vec3> moved = mesh.positions;
  for (Vec3& position : moved) position = position + Vec3{2, -3, 6};
  const Quality quality = measure_quality(mesh.graph, mesh.positions, moved);
  EXPECT_NEAR(quality.lfe_rms, 7, 1e-12);
  EXPECT_NEAR(quality.max_error, 7, 1e-12);
  EXPECT_LT(quality.vde_rms, 1e-13);
}

TEST(Quality, QUAL1FollowsEquationTwoOnATriangle) {
  // Edges 0-1: 3, 0-2: 4, 1-2: 5; vertex 0 moves to (0, 0, h), which changes the lengths of its edges.
  const GraphMesh mesh =
      test::finish({.positions = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, .triangles = {0, 1, 2}});
  std::vector<Vec3> decoded = mesh.positions;
  decoded[0][2] = 1;
  const double l01 = std::sqrt(10.0);
  const double l02 = std::sqrt(17.0);
  const auto weighted = [](const Vec3& v, const Vec3& a, double la, const Vec3& b, double lb) {
    return v - (1 / (1 / la + 1 / lb)) * ((1 / la) * a + (1 / lb) * b);
  };
  const auto& p = mesh.positions;
  const auto& q = decoded;
  const Vec3 e0 = weighted(p[0], p[1], 3, p[2], 4) - weighted(q[0], q[1], l01, q[2], l02);
  const Vec3 e1 = weighted(p[1], p[0], 3, p[2], 5) - weighted(q[1], q[0], l01, q[2], 5);
  const Vec3 e2 = weighted(p[2], p[0], 4, p[1], 5) - weighted(q[2], q[0], l02, q[1], 5);
  const Quality quality = measure_quality(mesh.graph, p, q);
  EXPECT_NEAR(quality.vde_rms, std::sqrt((dot(e0, e0) + dot(e1, e1) + dot(e2, e2)) / 3), 1e-14);
  EXPECT_NEAR(quality.lfe_rms, std::sqrt(1.0 / 3), 1e-15);
  EXPECT_EQ(quality.max_error, 1);
}

TEST(Quality, QUAL3VerticesWithoutNeighboursCountForTheMaximumAlone) {
  const GraphMesh mesh =
      test::finish({.positions = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {5, 5, 5}}, .triangles = {0, 1, 2}});
  std::vector<Vec3> decoded = mesh.positions;
  decoded[3] = {5, 5, 7};
  const Quality quality = measure_quality(mesh.graph, mesh.positions, decoded);
  EXPECT_EQ(quality.lfe_rms, 0);
  EXPECT_EQ(quality.vde_rms, 0);
  EXPECT_EQ(quality.max_error, 2);
}

TEST(Quality, ZeroLengthEdgesStayFinite) {
  GraphMesh mesh = test::sheet(6, 6);
  mesh.positions[8] = mesh.positions[7];
  std::vector<Vec3> decoded = mesh.positions;
  decoded[9] = decoded[15];
  EXPECT_TRUE(std::isfinite(measure_quality(mesh.graph, mesh.positions, decoded).vde_rms));
  const std::vector<Vec3> point(mesh.positions.size(), Vec3{1, 2, 3});
  const Quality quality = measure_quality(mesh.graph, point, point);
  EXPECT_EQ(quality.vde_rms, 0);
  EXPECT_EQ(quality.max_error, 0);
}

TEST(Quality, EdgesGiveTheSameVdeAsAGraph) {
  const GraphMesh mesh = test::sheet(30, 20);
  std::vector<Vec3> decoded = mesh.positions;
  for (std::size_t v = 0; v < decoded.size(); v += 3) decoded[v][v % 2] += 0.01 * static_cast<double>(v % 7);
  const double vde = measure_quality(mesh.graph, mesh.positions, decoded).vde_rms;
  const auto count = static_cast<std::uint32_t>(mesh.positions.size());
  const MeshEdges edges = find_edges(mesh.triangles, count);
  EXPECT_NEAR(measure_vde(edges, mesh.positions, decoded), vde, 1e-12 * vde);
  EXPECT_EQ(measure_vde(edges, mesh.positions, mesh.positions), 0);
}

TEST(Quality, AnEmptyMeshHasNoError) {
  const GraphMesh mesh = test::finish({});
  EXPECT_EQ(measure_quality(mesh.graph, {}, {}).lfe_rms, 0);
}

TEST(Quality, PaperFormIsThePlainSumAtUnitDiagonal) {
  const PaperQuality paper = paper_form({.vde_rms = 0.5, .lfe_rms = 3, .max_error = 9}, 400, 10);
  EXPECT_DOUBLE_EQ(paper.vde, 0.5 * 20 / 10);
  EXPECT_DOUBLE_EQ(paper.lfe, 3.0 * 20 / 10);
  EXPECT_EQ(paper_form({.vde_rms = 1, .lfe_rms = 1, .max_error = 1}, 5, 0).lfe, 0);
}

}  // namespace
}  // namespace deltamesh
