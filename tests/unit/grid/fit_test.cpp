// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Grids are found in meshes that were cut from them.
#include "grid/source/fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "deltamesh/encode.h"
#include "deltamesh/find_grid.h"
#include "format/container.h"
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
  const auto heights = fit_voxels(AxisValues(sheet.positions), sheet.box);
  EXPECT_TRUE(!heights || heights->along_one_axis == 1);
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

/// Ground in cubes of 0.1 m with slopes of at most 1 : 18, nearly all of whose vertices are on edges upwards.
Mesh gentle_ground() {
  test::RandomBits random(5);
  const scenes::Surface surface = test::marched(
      [&](int i, int j, int k) {
        const float hill = 0.8F * std::sin(static_cast<float>(i) / 15) * std::cos(static_cast<float>(j) / 18);
        const float noise = static_cast<float>(random() % 1000) / 5000;
        return static_cast<float>(k) - 20 - hill + noise;
      },
      120);
  Mesh mesh;
  mesh.triangles = surface.triangles;
  for (const float place : surface.positions) mesh.positions.push_back(0.1F * place);
  return mesh;
}

/// Heights in quarters of the distance of their grid.
Mesh stepped_heights() {
  Mesh heights;
  const test::GraphMesh sheet = test::sheet(60, 60);
  heights.triangles.assign(sheet.triangles.begin(), sheet.triangles.end());
  for (std::uint32_t v = 0; v < sheet.positions.size(); ++v) {
    const auto x = static_cast<float>(v % 61);
    const auto y = static_cast<float>(v / 61);
    for (const float at : {x, y, std::round(4 * (3 * std::sin(x / 15) + 2 * std::cos(y / 11))) / 4})
      heights.positions.push_back(at);
  }
  return heights;
}

TEST(FindGrid, OfVoxelsButNotOfHeightsOrAnythingElse) {
  const Mesh rooms = *generate_scene(Scene::kRooms, 3000, 3);
  const auto grid = find_grid(rooms);
  ASSERT_TRUE(grid);
  EXPECT_NEAR(grid->edge[0], grid->edge[2], 1e-6);
  EXPECT_TRUE(is_on_grid(*grid, rooms));
  VoxelGrid other = *grid;
  for (double& edge : other.edge) edge *= 0.37;
  EXPECT_FALSE(is_on_grid(other, rooms));
  EXPECT_FALSE(is_on_grid(*grid, Mesh()));
  EXPECT_FALSE(find_grid(stepped_heights()));
  EXPECT_FALSE(find_grid(*generate_scene(Scene::kSphere, 3000, 1)));
  EXPECT_FALSE(find_grid(Mesh()));
}

TEST(VoxelFit, GentleGroundIsOnEdgesAlongOneAxis) {
  const Mesh mesh = gentle_ground();
  Points points;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
    points.add({mesh.positions[3 * v], mesh.positions[3 * v + 1], mesh.positions[3 * v + 2]});
  const AxisValues values(points.positions);
  const auto fit = fit_voxels(values, points.box);
  ASSERT_TRUE(fit);
  EXPECT_GT(fit->along_one_axis, 0.9);
  const auto given = fit_to_grid({fit->origin, fit->voxel}, values, points.box);
  ASSERT_TRUE(given);
  EXPECT_GT(given->along_one_axis, 0.9);
  EXPECT_GT(for_most_faces(*given, values, mesh.triangles).in_cubes, 0.5);
}

/// Of a mesh that is on it the stream has the given grid to the bit, wherever it begins.
TEST(GivenGrid, IsThatOfTheStreamOrOfNoUse) {
  const Mesh rooms = *generate_scene(Scene::kRooms, 3000, 3);
  VoxelGrid grid = *find_grid(rooms);
  for (std::size_t axis = 0; axis < 3; ++axis) grid.origin[axis] -= 40 * grid.edge[axis];
  EncodeOptions options{.quality = {.max_error = QualityBound{0.01}}, .grid = grid};
  const auto on_grid = encode(rooms, options);
  ASSERT_TRUE(on_grid);
  const auto header = Container::open(on_grid->bytes)->header().predictive;
  EXPECT_EQ(header.lattice.origin, grid.origin);
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_EQ(header.lattice.step[axis], grid.edge[axis] / (2.0 * header.levels));
  for (double& edge : options.grid->edge) edge *= 0.37;
  const auto off_grid = encode(rooms, options);
  ASSERT_TRUE(off_grid);
  EXPECT_NE(off_grid->report.stream.geometry, "grid");
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    options.grid->edge[1] = bad;
    EXPECT_FALSE(validate(options)) << bad;
  }
}

TEST(VoxelFit, GentleGroundIsCodedInCubesAndHeightsOnALattice) {
  const auto ground = encode(gentle_ground(), {.quality = {.max_error = QualityBound{0.002}}});
  ASSERT_TRUE(ground);
  EXPECT_EQ(ground->report.stream.geometry, "grid");
  const auto on_lattice = encode(stepped_heights(), {.quality = {.max_error = QualityBound{0.1}}});
  ASSERT_TRUE(on_lattice);
  EXPECT_EQ(on_lattice->report.stream.geometry, "predictive");
}

}  // namespace
}  // namespace deltamesh::fit_test
