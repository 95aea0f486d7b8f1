// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Surfaces beside a mesh that readers have [MAP-26 to MAP-29].
#include <gtest/gtest.h>

#include <algorithm>

#include "deltamesh/known_mesh.h"
#include "grid_meshes.h"

namespace deltamesh {
namespace {

using test::CellMesh;

std::vector<float> positions_of(std::span<const Cell> cells) {
  std::vector<float> positions;
  for (const Cell& cell : cells)
    for (const std::int32_t at : cell) positions.push_back(static_cast<float>(at));
  return positions;
}

/// A mesh that readers have, and which faces of it stay.
struct Base {
  Base(const CellMesh& mesh, std::vector<std::uint8_t> which)
      : positions(positions_of(mesh.cells)), triangles(mesh.triangles), stays(std::move(which)) {}
  KnownMesh view() const { return {positions, triangles, stays}; }

  std::vector<float> positions;
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint8_t> stays;
};

std::vector<std::uint8_t> all(const CellMesh& mesh, std::uint8_t stay) {
  return std::vector<std::uint8_t>(mesh.triangles.size() / 3, stay);
}

/// Reads what write_grid() makes of `mesh` beside `base`; the bytes of that.
std::size_t expect_back(const CellMesh& mesh, const Base& base) {
  const KnownMesh known = base.view();
  const auto coded = write_grid(mesh.triangles, mesh.cells, mesh.parameters, nullptr, &known);
  EXPECT_TRUE(coded);
  if (!coded) return 0;
  const auto read =
      read_grid(chunks_of(coded->payloads), mesh.parameters, static_cast<std::uint32_t>(mesh.cells.size()),
                static_cast<std::uint32_t>(mesh.triangles.size() / 3), {}, &known);
  EXPECT_TRUE(read) << read.error().message;
  if (!read) return 0;
  EXPECT_EQ(read->triangles, coded->triangles);
  auto expected = positions_of(coded->surface_cells);
  for (std::size_t v = coded->surface_cells.size(); v < coded->vertex_order.size(); ++v)
    for (const std::int32_t at : mesh.cells[coded->vertex_order[v]])
      expected.push_back(static_cast<float>(at));
  EXPECT_EQ(read->positions, expected);
  return coded->payloads.bytes();
}

std::size_t bytes_alone(const CellMesh& mesh) {
  return write_grid(mesh.triangles, mesh.cells, mesh.parameters)->payloads.bytes();
}

/// As `mesh`, with every third vertex a level higher or lower.
CellMesh moved(CellMesh mesh) {
  for (std::size_t v = 0; v < mesh.cells.size(); v += 3) {
    for (std::int32_t& at : mesh.cells[v]) {
      const auto voxel = static_cast<std::int32_t>(2 * mesh.parameters.levels);
      if (at % 2 != 0) at += at % voxel == 1 ? 2 : -2;
    }
  }
  return mesh;
}

TEST(KnownSurface, MAP28WhatHasNotChangedTakesLittle) {
  const CellMesh mesh = test::wavy_surface(40, 4);
  EXPECT_LT(15 * expect_back(mesh, {mesh, all(mesh, 0)}), bytes_alone(mesh));
}

/// Low bits of levels are raw where there are more than 16.
TEST(KnownSurface, MAP29LevelsThatDoNotMoveTakeLittleHoweverManyThereAre) {
  for (const std::uint32_t levels : {1, 2, 16, 17, 64, 1000}) {
    SCOPED_TRACE(levels);
    const CellMesh mesh = test::wavy_surface(40, levels);
    EXPECT_LT((levels < 16 ? 10 : 15) * expect_back(mesh, {mesh, all(mesh, 0)}), bytes_alone(mesh));
    if (levels > 1) expect_back(moved(mesh), {mesh, all(mesh, 0)});
  }
}

TEST(KnownSurface, MAP29LevelsThatMoveTakeMore) {
  const CellMesh mesh = test::wavy_surface(40, 4);
  const std::size_t bytes = expect_back(moved(mesh), {mesh, all(mesh, 0)});
  EXPECT_LT(bytes, bytes_alone(moved(mesh)));
  EXPECT_GT(bytes, 2 * expect_back(mesh, {mesh, all(mesh, 0)}));
}

TEST(KnownSurface, MAP29VerticesAreWhereOnesThatStayAre) {
  const CellMesh mesh = test::wavy_surface(40, 4);
  const Base base(mesh, all(mesh, 1));
  const CellMesh other = moved(mesh);
  const KnownMesh view = base.view();
  const auto coded = write_grid(other.triangles, other.cells, other.parameters, nullptr, &view);
  ASSERT_TRUE(coded);
  for (std::size_t v = 0; v < coded->surface_cells.size(); ++v)
    EXPECT_EQ(coded->surface_cells[v], mesh.cells[coded->vertex_order[v]]);
  expect_back(other, base);
}

TEST(KnownSurface, MAP30VerticesAreFoundByTheirEdges) {
  const CellMesh mesh = test::wavy_surface(40, 4);
  std::vector<std::uint8_t> stays = all(mesh, 0);
  std::vector<std::uint8_t> is_of_staying(mesh.cells.size(), 0);
  for (std::size_t f = 0; f < stays.size(); f += 10) {
    stays[f] = 1;
    for (std::size_t c = 0; c < 3; ++c) is_of_staying[mesh.triangles[3 * f + c]] = 1;
  }
  const Base base(mesh, stays);
  const CellMesh other = moved(mesh);
  const KnownMesh view = base.view();
  const auto coded = write_grid(other.triangles, other.cells, other.parameters, nullptr, &view);
  ASSERT_TRUE(coded);
  ASSERT_EQ(coded->known.size(), mesh.cells.size());
  for (std::size_t v = 0; v < coded->known.size(); ++v) {
    EXPECT_EQ(coded->known[v].row, coded->vertex_order[v]);
    EXPECT_EQ(coded->known[v].stays, is_of_staying[coded->vertex_order[v]] != 0);
  }
  const auto read =
      read_grid(chunks_of(coded->payloads), other.parameters, static_cast<std::uint32_t>(other.cells.size()),
                static_cast<std::uint32_t>(other.triangles.size() / 3), {}, &view);
  ASSERT_TRUE(read);
  ASSERT_EQ(read->known.size(), coded->known.size());
  for (std::size_t v = 0; v < coded->known.size(); ++v) {
    EXPECT_EQ(read->known[v].row, coded->known[v].row);
    EXPECT_EQ(read->known[v].stays, coded->known[v].stays);
  }
}

TEST(KnownSurface, MAP27AnyMeshMayBeKnown) {
  const CellMesh mesh = test::wavy_surface(30, 4);
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    const CellMesh base = test::random_faces(seed, 30, 4, 400);
    std::vector<std::uint8_t> stays = all(base, 0);
    test::RandomBits random(seed);
    for (std::uint8_t& stay : stays) stay = random() % 3 == 0 ? 1 : 0;
    expect_back(mesh, {base, stays});
    expect_back(base, {mesh, all(mesh, static_cast<std::uint8_t>(seed % 2))});
  }
}

TEST(KnownSurface, MAP26PositionsMayBeAnywhere) {
  CellMesh mesh = test::wavy_surface(30, 4);
  Base base(mesh, all(mesh, 0));
  for (std::size_t i = 0; i < base.positions.size(); ++i)
    base.positions[i] += static_cast<float>(i % 7) * 0.3F - (i % 11 == 0 ? 1e30F : 0.0F);
  expect_back(mesh, base);
}

TEST(KnownSurface, MAP27RefusesTooManyBricks) {
  CellMesh mesh = test::wavy_surface(200, 1);
  const auto payloads = write_grid(mesh.triangles, mesh.cells, mesh.parameters)->payloads;
  Base base(mesh, all(mesh, 0));
  base.positions.clear();
  base.triangles.clear();
  base.stays.clear();
  for (int i = 0; i < 100; ++i)
    for (const int at : {i % 10 * 40 + 1, i / 10 * 40, 0}) base.positions.push_back(static_cast<float>(at));
  const KnownMesh known = base.view();
  EXPECT_FALSE(write_grid(mesh.triangles, mesh.cells, mesh.parameters, nullptr, &known));
  const auto read =
      read_grid(chunks_of(payloads), mesh.parameters, static_cast<std::uint32_t>(mesh.cells.size()),
                static_cast<std::uint32_t>(mesh.triangles.size() / 3), {}, &known);
  ASSERT_FALSE(read);
  EXPECT_STREQ(read.error().rule, "MAP-27");
}

}  // namespace
}  // namespace deltamesh
