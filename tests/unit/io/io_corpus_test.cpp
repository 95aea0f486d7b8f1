// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Every mesh of the corpus is read with the counts that its README states.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "io_support.h"

namespace deltamesh {
namespace {

struct Expected {
  const char* file;
  std::size_t vertices;  ///< OBJ: distinct corners
  std::size_t triangles;
  std::size_t attributes;
};

constexpr Expected kMeshes[] = {
    {"formats/Duck.glb", 2399, 4212, 2},
    {"formats/Lantern.gltf", 4145, 5394, 3},
    {"formats/boat.glb", 16665, 32416, 2},
    {"formats/bun_zipper_ascii.ply", 35947, 69451, 2},
    {"formats/casting.off", 5096, 10224, 0},
    {"formats/chair_model.obj", 11250, 12756, 1},
    {"formats/conrod.stl", 3223, 6442, 0},
    {"formats/fuze.obj", 664, 1000, 2},
    {"formats/horse_quad.obj", 2400, 4796, 0},
    {"formats/inspired_quads.off", 1749, 3266, 0},
    {"formats/kitchen_tsdf_40mm.glb", 25111, 45799, 2},
    {"formats/screwdriver_big_endian.ply", 6789, 13574, 1},
    {"formats/spot.obj", 3225, 5856, 1},
    {"formats/suzanne.obj", 507, 968, 1},
    {"formats/suzanne_ascii_uv_normals.ply", 1966, 968, 2},
    {"formats/texturedknot_wedge_uv.ply", 1573, 2880, 1},
    {"formats/tray_bottom_ascii.stl", 2216, 4520, 0},
    {"formats/trumpet.obj", 11908, 23696, 0},
    {"models/armadillo_43k.ply", 43243, 86482, 0},
    {"models/beetle.ply", 19887, 38656, 0},
    {"models/chair_nonmanifold.ply", 3186, 12756, 0},
    {"models/cycloidal_gear.ply", 21384, 43368, 0},
    {"models/dragon_100k.ply", 100250, 202520, 0},
    {"models/fandisk.ply", 6475, 12946, 0},
    {"models/horse.ply", 48485, 96966, 0},
    {"models/laurana50k.ply", 27861, 49954, 1},
    {"models/lucy_50k.ply", 49987, 99970, 0},
    {"models/nefertiti_50k.ply", 49971, 99938, 0},
    {"models/ogre.ply", 62194, 124008, 0},
    {"models/rangemap_lato180.ply", 44322, 84635, 0},
    {"models/rocker_arm.ply", 10044, 20088, 0},
    {"models/sword_quads.ply", 22293, 44582, 0},
    {"models/teapot.ply", 3644, 6320, 0},
    {"paper/armadillo_18245.ply", 18245, 36486, 0},
    {"paper/bunny_34834.ply", 34834, 69451, 0},
    {"paper/happy_buddha_49990.ply", 49990, 100000, 0},
    {"paper/horse_4243.ply", 4243, 8482, 0},
    {"paper/laurana_6301.ply", 6301, 12304, 0},
    {"robot/autzen_tin_rgb.ply", 109961, 219236, 1},
    {"robot/building_sim_250k.ply", 262479, 489396, 1},
    {"robot/building_sim_50k.ply", 55215, 102983, 2},
    {"robot/building_sim_50k_blocks.ply", 61335, 102983, 2},
    {"robot/helens_dem_grid.ply", 148885, 296192, 0},
    {"robot/kitchen_tsdf_10mm_half.ply", 214947, 401598, 1},
    {"robot/kitchen_tsdf_20mm.ply", 101919, 188157, 1},
    {"robot/kitti_lidar_tsdf_150mm.ply", 137368, 206627, 1},
    {"robot/sequence_kitchen/step_00.ply", 8514, 14516, 1},
    {"robot/sequence_sim/step_00_changed.ply", 11778, 19631, 1},
};

std::filesystem::path corpus() {
  const char* const given = std::getenv("DELTAMESH_CORPUS");
  return given != nullptr ? given : DELTAMESH_SOURCE_DIR "/../shared/corpus";
}

TEST(IoCorpus, CountsAgreeWithTheTable) {
  if (!std::filesystem::is_directory(corpus())) GTEST_SKIP() << "skipped: no corpus";
  for (const Expected& expected : kMeshes) {
    SCOPED_TRACE(expected.file);
    const auto imported = read_mesh_file((corpus() / expected.file).string());
    ASSERT_TRUE(imported) << describe(imported.error());
    EXPECT_EQ(imported->mesh.vertex_count(), expected.vertices);
    EXPECT_EQ(imported->mesh.triangle_count(), expected.triangles);
    EXPECT_EQ(imported->mesh.attributes.size(), expected.attributes);
    EXPECT_EQ(test::left_out(imported->report, LeftOutKind::kFaces), 0U);
    EXPECT_EQ(test::left_out(imported->report, LeftOutKind::kPrimitives), 0U);
    for (const std::uint32_t index : imported->mesh.triangles) ASSERT_LT(index, expected.vertices);
  }
}

TEST(IoCorpus, UtmCoordinatesKeepTheirPrecision) {
  if (!std::filesystem::is_directory(corpus())) GTEST_SKIP() << "skipped: no corpus";
  const auto imported = read_mesh_file((corpus() / "robot/helens_dem_grid.ply").string());
  ASSERT_TRUE(imported) << describe(imported.error());
  const Mesh& mesh = imported->mesh;
  EXPECT_GT(mesh.origin[1], 5.0e6);
  // The grid has whole metres: origin plus local coordinate gives them back exactly.
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const double world = mesh.origin[i % 3] + static_cast<double>(mesh.positions[i]);
    ASSERT_EQ(world, static_cast<double>(static_cast<float>(world)));
  }
}

}  // namespace
}  // namespace deltamesh
