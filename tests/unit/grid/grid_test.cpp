// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The grid coder: what it writes comes back, and what it cannot read it refuses.
#include "grid/grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <vector>

#include "connectivity/faces/faces.h"
#include "entropy/coder/writer.h"
#include "grid/bounds.h"
#include "grid/growth.h"
#include "grid/rest/rest.h"
#include "grid/source/cubes.h"
#include "grid_meshes.h"
#include "positions/positions.h"
#include "support/random.h"

namespace deltamesh::grid_test {
namespace {

using test::CellMesh;

std::uint32_t face_count(const CellMesh& mesh) {
  return static_cast<std::uint32_t>(mesh.triangles.size() / 3);
}
std::uint32_t vertex_count(const CellMesh& mesh) { return static_cast<std::uint32_t>(mesh.cells.size()); }

CodedGrid write(const CellMesh& mesh) {
  return write_grid(mesh.triangles, mesh.cells, mesh.parameters).value_or(CodedGrid{});
}
Result<GridMesh> read(const CellMesh& mesh, const GridPayloads& payloads) {
  return read_grid(chunks_of(payloads), mesh.parameters, vertex_count(mesh), face_count(mesh));
}

std::vector<std::uint32_t> ascending(std::vector<std::uint32_t> numbers) {
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}
std::vector<std::uint32_t> all_below(std::uint32_t count) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0U);
  return numbers;
}

/// That `coded` has the mesh's faces and vertices, each once, and comes back.
void expect_back(const CellMesh& mesh, const CodedGrid& coded) {
  ASSERT_EQ(ascending(coded.face_order), all_below(face_count(mesh)));
  ASSERT_EQ(ascending(coded.vertex_order), all_below(vertex_count(mesh)));
  for (std::size_t f = 0; f < coded.face_order.size(); ++f)
    for (std::size_t c = 0; c < 3; ++c)
      ASSERT_EQ(coded.vertex_order[coded.triangles[3 * f + c]],
                mesh.triangles[std::size_t{3} * coded.face_order[f] + (coded.face_rotation[f] + c) % 3]);
  const auto back = read(mesh, coded.payloads);
  ASSERT_TRUE(back) << back.error().message << back.error().rule;
  ASSERT_EQ(back->triangles, coded.triangles);
  std::vector<float> positions;
  for (const std::uint32_t v : coded.vertex_order)
    for (std::size_t axis = 0; axis < 3; ++axis)
      positions.push_back(static_cast<float>(mesh.parameters.lattice.at(axis, mesh.cells[v][axis])));
  ASSERT_EQ(back->positions, positions);
}

TEST(Grid, GRD3GRD4GRD5GRD7GRD10MarchingCubesComeBack) {
  for (const std::uint32_t levels : {1U, 2U, 10U, 16U, 17U, 300U, 100000U}) {
    const CellMesh mesh = test::wavy_surface(40, levels);
    const CodedGrid coded = write(mesh);
    EXPECT_EQ(coded.rest_triangles, 0U);
    EXPECT_EQ(coded.payloads.bytes(), coded.payloads.surface.size());
    expect_back(mesh, coded);
  }
}

TEST(Grid, GRD5GRD6AnyFacesInCubesComeBack) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const CellMesh mesh = test::random_faces(seed, 3 + 2 * seed, 1 + seed % 4, 10 + 80 * (seed % 7));
    expect_back(mesh, write(mesh));
  }
}

TEST(Grid, FacesInNoCubeComeBack) {
  CellMesh mesh = test::wavy_surface(24, 4);
  const std::uint32_t far = mesh.triangles[mesh.triangles.size() / 2];
  mesh.triangles.insert(mesh.triangles.end(), {mesh.triangles[0], mesh.triangles[1], far});
  mesh.triangles.insert(mesh.triangles.end(), {far, far, mesh.triangles[1]});
  // A second vertex on an edge, at the same point, and one without faces.
  mesh.cells.push_back(mesh.cells[mesh.triangles[0]]);
  mesh.triangles.insert(mesh.triangles.end(), {vertex_count(mesh) - 1, mesh.triangles[1], mesh.triangles[2]});
  mesh.cells.push_back({3, 4, 5});
  const CodedGrid coded = write(mesh);
  EXPECT_EQ(coded.rest_triangles, 3U);
  expect_back(mesh, coded);
}

TEST(Grid, MeshesThatAreHalfOfCubesComeBack) {
  test::RandomBits random(4);
  for (const bool has_inner : {false, true}) {
    CellMesh mesh = has_inner ? test::random_faces(1, 12, 3, 500) : test::wavy_surface(24, 4);
    const std::uint32_t before = vertex_count(mesh);
    for (std::uint32_t i = 0; i < 300; ++i) {
      Cell& cell = mesh.cells.emplace_back();
      for (std::int32_t& at : cell) at = static_cast<std::int32_t>(random() % 60);
      for (int c = 0; c < 3; ++c)
        mesh.triangles.push_back(random() % 4 == 0 ? random() % before : before + random() % (i + 1));
    }
    const CodedGrid coded = write(mesh);
    EXPECT_GT(coded.rest_triangles, 200U);
    expect_back(mesh, coded);
  }
}

TEST(Grid, GRD11RefusesARestThatDoesNotFit) {
  CellMesh mesh = test::wavy_surface(24, 4);
  GridPayloads payloads = write(mesh).payloads;
  payloads.rest_faces.resize(3);
  EXPECT_STREQ(read(mesh, payloads).error().rule, "GRD-11");
  mesh.triangles.insert(mesh.triangles.end(), {0, 1, mesh.triangles[mesh.triangles.size() / 2]});
  payloads = write(mesh).payloads;
  ASSERT_TRUE(read(mesh, payloads));
  payloads.rest_faces.clear();
  EXPECT_FALSE(read(mesh, payloads));
}

TEST(Grid, NothingComesBack) {
  const CellMesh mesh{{}, {}, test::voxel_parameters(5, 2)};
  const CodedGrid coded = write(mesh);
  expect_back(mesh, coded);
  EXPECT_LT(coded.payloads.bytes(), 8U);
}

TEST(Grid, TakesLessThanFacesAndPlacesApart) {
  const CellMesh mesh = test::wavy_surface(60, 10);
  const CodedGrid coded = write(mesh);
  const auto faces = write_connectivity(mesh.triangles, vertex_count(mesh));
  std::vector<Cell> cells;
  for (const std::uint32_t v : faces.vertex_order) cells.push_back(mesh.cells[v]);
  const auto positions =
      write_positions({faces.triangles, vertex_count(mesh)}, cells, {.lattice = mesh.parameters.lattice});
  EXPECT_LT(static_cast<double>(coded.payloads.bytes()),
            0.72 * static_cast<double>(faces.payload.size() + positions.size()));
}

TEST(Grid, TheSameMeshGivesTheSameBytes) {
  const CellMesh mesh = test::wavy_surface(30, 3);
  EXPECT_EQ(write(mesh).payloads.surface, write(mesh).payloads.surface);
}

TEST(Grid, GRD8RefusesMoreOrLessThanTheHeaderSays) {
  const CellMesh mesh = test::wavy_surface(24, 4);
  const GridPayloads payloads = write(mesh).payloads;
  for (const int step : {-1, 1}) {
    const auto vertices =
        read_grid(chunks_of(payloads), mesh.parameters, vertex_count(mesh) + step, face_count(mesh));
    ASSERT_FALSE(vertices);
    EXPECT_STREQ(vertices.error().rule, "GRD-8");
    const auto faces =
        read_grid(chunks_of(payloads), mesh.parameters, vertex_count(mesh), face_count(mesh) + step);
    ASSERT_FALSE(faces);
    EXPECT_STREQ(faces.error().rule, "GRD-8");
  }
}

/// One face in each of `count` cubes at the corners of bricks, eight to a cube.
CellMesh faces_at_corners_of_bricks(std::uint32_t count) {
  CellMesh mesh{{}, {}, test::voxel_parameters(40 * count, 1)};
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto at = static_cast<std::int32_t>(2 * (32 * i + 15));
    const std::uint32_t first = vertex_count(mesh);
    for (const Cell& cell : {Cell{at + 1, at, at}, Cell{at, at + 1, at}, Cell{at, at, at + 1}})
      mesh.cells.push_back(cell);
    mesh.triangles.insert(mesh.triangles.end(), {first, first + 1, first + 2});
  }
  return mesh;
}

TEST(Grid, GRD8RefusesTooManyBricks) {
  const CellMesh few = faces_at_corners_of_bricks(8);
  expect_back(few, write(few));
  const CellMesh mesh = faces_at_corners_of_bricks(20);
  EXPECT_FALSE(write_grid(mesh.triangles, mesh.cells, mesh.parameters));
  // As a writer with other limits would have it.
  auto limits = grid::limits_of(mesh.parameters, vertex_count(mesh), face_count(mesh));
  const grid::SourceCubes source(mesh.triangles, mesh.cells, 1, limits.bricks);
  limits.most_bricks = 1000;
  CompactWriter writer;
  grid::RestModels rest_models;
  grid::RestSize rest;
  code_rest_size(writer, rest, rest_models);
  const auto models = std::make_unique<grid::GrowthModels>();
  grid::Surface surface;
  grid::KnownGrowth known(nullptr);
  ASSERT_EQ(grid::Growth(writer, *models, source, limits, surface, known).grow(), nullptr);
  const auto back = read(mesh, {.surface = writer.finish(), .rest_faces = {}});
  ASSERT_FALSE(back);
  EXPECT_STREQ(back.error().rule, "GRD-8");
}

TEST(Grid, GRD9RefusesVerticesBeyondTheLattice) {
  CellMesh mesh = test::wavy_surface(24, 4);
  const GridPayloads payloads = write(mesh).payloads;
  mesh.parameters.lattice.cells[0] -= 9;
  const auto back = read(mesh, payloads);
  ASSERT_FALSE(back);
  EXPECT_STREQ(back.error().rule, "GRD-9");
}

TEST(Grid, GRD1RefusesTooManyBricks) {
  const CellMesh mesh{{}, {}, test::voxel_parameters(100000000, 1)};
  EXPECT_FALSE(write_grid(mesh.triangles, mesh.cells, mesh.parameters));
  const auto back = read(mesh, write({{}, {}, test::voxel_parameters(5, 1)}).payloads);
  ASSERT_FALSE(back);
  EXPECT_STREQ(back.error().rule, "GRD-1");
}

TEST(Grid, CutStreamsAreRefused) {
  const CellMesh mesh = test::random_faces(3, 6, 2, 40);
  const GridPayloads payloads = write(mesh).payloads;
  for (std::size_t size = 0; size < payloads.surface.size(); ++size) {
    GridPayloads cut = payloads;
    cut.surface.resize(size);
    EXPECT_FALSE(read(mesh, cut)) << size;
  }
}

TEST(Grid, BrokenStreamsAreRefusedOrInRange) {
  test::RandomBits random(5);
  for (const bool is_soup : {false, true}) {
    const CellMesh mesh = is_soup ? test::random_faces(4, 20, 3, 400) : test::wavy_surface(20, 20);
    const GridPayloads payloads = write(mesh).payloads;
    for (int round = 0; round < 400; ++round) {
      GridPayloads broken = payloads;
      auto& bytes = broken.surface;
      for (int i = 0; i <= round % 3; ++i)
        bytes[random() % std::min<std::size_t>(bytes.size(), round % 2 == 0 ? 40 : bytes.size())] ^=
            static_cast<std::byte>(1U << random() % 8);
      const auto back = read(mesh, broken);
      if (!back) continue;
      for (const std::uint32_t v : back->triangles) ASSERT_LT(v, vertex_count(mesh));
      for (std::size_t i = 0; i < back->positions.size(); ++i) {
        ASSERT_GE(back->positions[i], mesh.parameters.lattice.at(i % 3, 0));
        ASSERT_LE(back->positions[i],
                  mesh.parameters.lattice.at(i % 3, mesh.parameters.lattice.cells[i % 3]));
      }
    }
  }
}

}  // namespace
}  // namespace deltamesh::grid_test
