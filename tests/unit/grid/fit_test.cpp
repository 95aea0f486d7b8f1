// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Grids are found in meshes that were cut from them.
#include "grid/source/fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "grid_meshes.h"
#include "scenes.h"
#include "support/graph_mesh.h"

namespace deltamesh::fit_test {
namespace {

struct Points {
  std::vector<Vec3> positions;
  std::vector<std::uint32_t> triangles;

  void add(const Vec3& position) {
    positions.push_back(position);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = std::min(box.min[axis], position[axis]);
      box.max[axis] = std::max(box.max[axis], position[axis]);
    }
  }
  Box box{{1e9, 1e9, 1e9}, {-1e9, -1e9, -1e9}};
};

/// Adds `mesh` with cubes of this size, its node 0 at `offset`.
void add(Points& points, const test::CellMesh& mesh, double voxel, double offset) {
  const auto first = static_cast<std::uint32_t>(points.positions.size());
  const double step = voxel / (2.0 * mesh.parameters.levels);
  for (const Cell& cell : mesh.cells)
    points.add({step * cell[0] + offset, step * cell[1] + offset, step * cell[2] + offset});
  for (const std::uint32_t v : mesh.triangles) points.triangles.push_back(first + v);
}

TEST(VoxelFit, TheGridIsFound) {
  const Mesh mesh = *generate_scene(Scene::kRooms, 3000, 3);
  Points points;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
    points.add({mesh.positions[3 * v], mesh.positions[3 * v + 1], mesh.positions[3 * v + 2]});
  const auto fit = fit_voxels(AxisValues(points.positions), points.box);
  ASSERT_TRUE(fit);
  EXPECT_GT(fit->share, 0.95);
  const VoxelFit same = for_most_faces(*fit, AxisValues(points.positions), mesh.triangles);
  EXPECT_EQ(same.voxel, fit->voxel);
  EXPECT_GT(same.in_cubes, 0.95);
  const test::GraphMesh sheet = test::sheet(20, 20);
  EXPECT_FALSE(fit_voxels(AxisValues(sheet.positions), sheet.box));
  EXPECT_FALSE(fit_voxels(AxisValues({}), {}));
}

TEST(VoxelFit, CubesAreOfTheSizeThatMostFacesOfAnOctreeLieIn) {
  // Cubes of 1 and of 2, with nodes at odd places; which of them are more decides.
  for (const std::uint32_t fine_nodes : {30U, 12U}) {
    Points points;
    add(points, test::wavy_surface(20, 50), 2, 1);
    add(points, test::wavy_surface(fine_nodes, 40), 1, 41);
    const AxisValues values(points.positions);
    const VoxelFit fine{.origin = {0, 0, 0}, .voxel = {1, 1, 1}, .noise = 1e-4};
    const VoxelFit fit = for_most_faces(fine, values, points.triangles);
    const double size = fine_nodes > 20 ? 1 : 2;
    EXPECT_EQ(fit.voxel, (Vec3{size, size, size}));
    EXPECT_EQ(fit.origin, (size > 1 ? Vec3{-1, -1, -1} : Vec3{0, 0, 0}));
    EXPECT_GT(fit.in_cubes, 0.5);
    // A grid that is given stays.
    VoxelFit given = fine;
    given.is_given = true;
    EXPECT_EQ(for_most_faces(given, values, points.triangles).voxel, fine.voxel);
  }
}

}  // namespace
}  // namespace deltamesh::fit_test
