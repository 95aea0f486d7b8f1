// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Surfaces beside a mesh that readers have [MAP-26 to MAP-29].
#include <gtest/gtest.h>

#include <array>

#include "deltamesh/known_mesh.h"
#include "grid/known/vertex.h"
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

/// A mesh that readers have.
struct Base {
  // NOLINTNEXTLINE(google-explicit-constructor): any mesh may be one
  Base(const CellMesh& mesh) : positions(positions_of(mesh.cells)), triangles(mesh.triangles) {}
  KnownMesh view() const { return {positions, triangles}; }

  std::vector<float> positions;
  std::vector<std::uint32_t> triangles;
};

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
  EXPECT_LT(15 * expect_back(mesh, mesh), bytes_alone(mesh));
}

/// Low bits of levels are raw where there are more than 16.
TEST(KnownSurface, MAP29LevelsThatDoNotMoveTakeLittleHoweverManyThereAre) {
  for (const std::uint32_t levels : {1, 2, 16, 17, 64, 1000}) {
    SCOPED_TRACE(levels);
    const CellMesh mesh = test::wavy_surface(40, levels);
    EXPECT_LT((levels < 16 ? 10 : 15) * expect_back(mesh, mesh), bytes_alone(mesh));
    if (levels > 1) expect_back(moved(mesh), mesh);
  }
}

TEST(KnownSurface, MAP29LevelsThatMoveTakeMore) {
  const CellMesh mesh = test::wavy_surface(40, 4);
  const std::size_t bytes = expect_back(moved(mesh), mesh);
  EXPECT_LT(bytes, bytes_alone(moved(mesh)));
  EXPECT_GT(bytes, 2 * expect_back(mesh, mesh));
}

TEST(KnownSurface, MAP30VerticesAreFoundByTheirEdges) {
  const CellMesh mesh = test::wavy_surface(40, 4);
  const Base base(mesh);
  const CellMesh other = moved(mesh);
  const KnownMesh view = base.view();
  const auto coded = write_grid(other.triangles, other.cells, other.parameters, nullptr, &view);
  ASSERT_TRUE(coded);
  EXPECT_EQ(coded->known, coded->vertex_order);
  const auto read =
      read_grid(chunks_of(coded->payloads), other.parameters, static_cast<std::uint32_t>(other.cells.size()),
                static_cast<std::uint32_t>(other.triangles.size() / 3), {}, &view);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->known, coded->known);
}

/// As `mesh`, without the faces of every cube for which `goes` says so of its lowest corner's x and y.
CellMesh without(CellMesh mesh, bool (*goes)(std::int32_t, std::int32_t)) {
  const auto voxel = static_cast<std::int32_t>(2 * mesh.parameters.levels);
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> numbers(mesh.cells.size(), kNoKnownVertex);
  std::vector<Cell> cells;
  for (std::size_t f = 0; f < mesh.triangles.size(); f += 3) {
    std::array<std::int32_t, 2> sums{};
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t k = 0; k < 2; ++k) sums[k] += mesh.cells[mesh.triangles[f + c]][k];
    if (goes(sums[0] / 3 / voxel, sums[1] / 3 / voxel)) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t v = mesh.triangles[f + c];
      if (numbers[v] == kNoKnownVertex) {
        numbers[v] = static_cast<std::uint32_t>(cells.size());
        cells.push_back(mesh.cells[v]);
      }
      triangles.push_back(numbers[v]);
    }
  }
  mesh.triangles = std::move(triangles);
  mesh.cells = std::move(cells);
  return mesh;
}

/// Flags of cubes that had no faces have models of their own beside those that had: a surface that ended
/// there ends there again.
TEST(KnownSurface, MAP28EndsStayEnds) {
  const CellMesh mesh = test::wavy_surface(60, 2);
  const CellMesh holes = without(mesh, [](std::int32_t x, std::int32_t y) { return x % 9 < 4 && y % 9 < 4; });
  EXPECT_LT(15 * expect_back(holes, holes), bytes_alone(holes));
  expect_back(holes, mesh);
  expect_back(mesh, holes);
}

TEST(KnownSurface, MAP27AnyMeshMayBeKnown) {
  const CellMesh mesh = test::wavy_surface(30, 4);
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    const CellMesh base = test::random_faces(seed, 30, 4, 400);
    expect_back(mesh, base);
    expect_back(base, mesh);
  }
}

TEST(KnownSurface, MAP26PositionsMayBeAnywhere) {
  CellMesh mesh = test::wavy_surface(30, 4);
  Base base(mesh);
  for (std::size_t i = 0; i < base.positions.size(); ++i)
    base.positions[i] += static_cast<float>(i % 7) * 0.3F - (i % 11 == 0 ? 1e30F : 0.0F);
  expect_back(mesh, base);
}

TEST(KnownSurface, MAP27RefusesTooManyBricks) {
  CellMesh mesh = test::wavy_surface(200, 1);
  const auto payloads = write_grid(mesh.triangles, mesh.cells, mesh.parameters)->payloads;
  Base base(mesh);
  base.positions.clear();
  base.triangles.clear();
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
