// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Vertices of faces that lie in no cube, which are mostly those of the surface beside.
#include "grid/rest/rest.h"

#include <gtest/gtest.h>

#include <memory>
#include <numeric>
#include <vector>

#include "entropy/coder/reader.h"
#include "entropy/coder/writer.h"
#include "grid/bounds.h"
#include "grid/grid.h"
#include "grid/growth.h"
#include "grid/places.h"
#include "grid/source/cubes.h"
#include "grid_meshes.h"

namespace deltamesh::rest_test {
namespace {

using test::CellMesh;

/// A surface as a writer knows it.
struct Written {
  explicit Written(const CellMesh& mesh) : levels(mesh.parameters.levels) {
    const auto limits = grid::limits_of(mesh.parameters, static_cast<std::uint32_t>(mesh.cells.size()),
                                        static_cast<std::uint32_t>(mesh.triangles.size() / 3));
    const grid::SourceCubes source(mesh.triangles, mesh.cells, levels, limits.bricks);
    CompactWriter writer;
    const auto models = std::make_unique<grid::GrowthModels>();
    grid::KnownGrowth known(nullptr);
    EXPECT_EQ(grid::Growth(writer, *models, source, limits, surface, known).grow(), nullptr);
    cells.resize(surface.vertex_count);
    std::size_t next = 0;
    for (const std::uint32_t cube : surface.cubes) {
      for (const auto& face : source.faces(cube)) {
        for (std::size_t c = 0; c < 3; ++c)
          cells[surface.triangles[next][c]] =
              mesh.cells[mesh.triangles[3 * std::size_t{face.face} + (face.turn + c) % 3]];
        ++next;
      }
    }
  }
  std::uint32_t levels;
  grid::Surface surface;
  std::vector<Cell> cells;
};

TEST(GridRest, GRD11EveryVertexIsFoundWhereItIs) {
  for (const CellMesh& mesh : {test::wavy_surface(24, 4), test::random_faces(2, 9, 3, 200)}) {
    const Written written(mesh);
    const grid::VertexFinder finder(written.surface, written.cells, written.levels);
    ASSERT_GT(written.cells.size(), 100U);
    for (std::uint32_t v = 0; v < written.cells.size(); ++v) ASSERT_EQ(finder.find(finder.place_of(v)), v);
    EXPECT_EQ(finder.find({.node = {0, 0, 0}, .axis = grid::VertexPlace::kInCube}), grid::kNoVertex);
    EXPECT_EQ(finder.find({.node = {1 << 20, 0, 0}, .axis = 1}), grid::kNoVertex);
  }
}

/// A fan around the surface's vertex 0 over the ten after it.
std::vector<std::uint32_t> fan() {
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t v = 1; v < 10; ++v) triangles.insert(triangles.end(), {0, v, v + 1});
  return triangles;
}

TEST(GridRest, GRD11RefusesVerticesThatTheSurfaceDoesNotHave) {
  const CellMesh mesh = test::wavy_surface(24, 4);
  const Written written(mesh);
  const Written other(test::wavy_surface(12, 4));
  const std::vector<std::uint32_t> triangles = fan();
  const KnownFaces faces({triangles, 11});
  for (const std::uint32_t first : {0U, static_cast<std::uint32_t>(written.cells.size()) - 11}) {
    std::vector<std::uint32_t> numbers(11);
    std::iota(numbers.begin(), numbers.end(), first);
    std::vector<Cell> cells(11);
    CompactWriter writer;
    grid::RestModels models;
    const grid::VertexFinder finder(written.surface, written.cells, written.levels);
    ASSERT_EQ(grid::RestCoder(writer, models, faces, finder, mesh.parameters.lattice.cells)
                  .code({}, numbers, cells),
              nullptr);
    const auto bytes = writer.finish();
    const auto reads = [&](const Written& surface) {
      CompactReader reader(bytes);
      grid::RestModels fresh;
      std::vector<std::uint32_t> read(11);
      const grid::VertexFinder places(surface.surface, surface.cells, surface.levels);
      const char* const rule =
          grid::RestCoder(reader, fresh, faces, places, mesh.parameters.lattice.cells).code({}, read, cells);
      return rule == nullptr && !reader.failed() && read == numbers;
    };
    EXPECT_TRUE(reads(written));
    EXPECT_FALSE(reads(other));
  }
}

TEST(GridRest, VerticesOfTheSurfaceCostFewBits) {
  CellMesh mesh = test::wavy_surface(40, 100);
  const auto before = write_grid(mesh.triangles, mesh.cells, mesh.parameters);
  ASSERT_TRUE(before);
  // Faces over two that are side by side.
  const auto faces = static_cast<std::uint32_t>(mesh.triangles.size() / 3);
  std::uint32_t added = 0;
  for (std::uint32_t f = 0; f + 1 < faces; f += 20) {
    const std::uint32_t* const corners = &mesh.triangles[3 * std::size_t{f}];
    mesh.triangles.insert(mesh.triangles.end(), {corners[0], corners[4], corners[2]});
    ++added;
  }
  const auto after = write_grid(mesh.triangles, mesh.cells, mesh.parameters);
  ASSERT_TRUE(after);
  ASSERT_GT(after->rest_triangles, added / 4);
  const auto more =
      static_cast<double>(after->payloads.bytes()) - static_cast<double>(before->payloads.bytes());
  EXPECT_LT(8 * more, 3 * 12.0 * added);
}

}  // namespace
}  // namespace deltamesh::rest_test
