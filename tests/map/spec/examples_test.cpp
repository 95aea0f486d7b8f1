// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The worked examples of maps: two triangles in two parts, and a corner of a grid that changes.
#include <gtest/gtest.h>

#include <numeric>
#include <string>

#include "attributes/colors/colors.h"
#include "deltamesh/known_mesh.h"
#include "deltamesh/map/fragment.h"
#include "deltamesh/map/map_codec.h"
#include "deltamesh/map/messages.h"
#include "deltamesh/map/split.h"
#include "grid/grid.h"
#include "patch/payload.h"
#include "spec/example_lines.h"

namespace deltamesh {
namespace {

using test::bytes_of;
using test::line_of;

const MapDescription kDescription = {
    .id = 7, .epoch = 1, .frame = "map", .lattice = {.step_exponent = -2}, .cell_steps = 8};

TEST(MapExamples, MAP5MessageOfTheMap) {
  const auto message = bytes_of("map.md", "message");
  const auto written = write_description(kDescription);
  ASSERT_TRUE(written);
  EXPECT_EQ(*written, message);
  const auto read = read_description(message);
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(*read, kDescription);
}

TEST(MapExamples, MAP2MAP4MAP7MAP8MAP11TwoParts) {
  Mesh mesh;
  mesh.positions = line_of<float>("map.md", "positions");
  mesh.triangles = {0, 1, 2, 2, 1, 3};
  const auto points = line_of<std::int32_t>("map.md", "points");
  ASSERT_EQ(points.size(), mesh.positions.size());
  for (std::size_t at = 0; at < points.size(); at += 3) {
    const float* p = mesh.positions.data() + at;
    EXPECT_EQ(kDescription.lattice.nearest({p[0], p[1], p[2]}),
              (LatticePoint{points[at], points[at + 1], points[at + 2]}));
  }
  const auto parts = split(mesh, kDescription, {.most_level = 0});
  ASSERT_TRUE(parts) << describe(parts.error());
  ASSERT_EQ(parts->size(), 2U);
  const auto codec = MapCodec::open(kDescription);
  ASSERT_TRUE(codec);
  for (const std::size_t i : {0, 1}) {
    const std::string number = std::to_string(i);
    const MapPart& part = (*parts)[i];
    const auto coded = codec->encode(
        part,
        {.bounds = {.max_error = QualityBound{0.25}}, .geometry = GeometryCoder::kPredictive, .effort = 0});
    ASSERT_TRUE(coded) << describe(coded.error());
    EXPECT_EQ(coded->bytes, bytes_of("map.md", "part-" + number));
    const auto decoded = codec->decode(part.key, coded->bytes);
    ASSERT_TRUE(decoded) << describe(decoded.error());
    EXPECT_EQ(decoded->mesh.positions, line_of<float>("map.md", "decoded-" + number));
    std::vector<std::uint32_t> border;
    for (const BorderVertex& vertex : decoded->border) border.push_back(vertex.vertex);
    EXPECT_EQ(border, line_of<std::uint32_t>("map.md", "border-" + number));
  }
}

TEST(MapExamples, MAP23MAP25APoseInFragments) {
  const PoseMessage pose{.map = hash_of(kDescription),
                         .start = 1,
                         .number = 5,
                         .pose = {1'500'000'000, {0.5, 0.5, 0.5, 0.5}, {1, 2, -0.5}}};
  const auto written = write_pose(pose);
  ASSERT_TRUE(written);
  EXPECT_EQ(*written, bytes_of("map.md", "pose"));
  const auto pieces = cut_message(*written, 64);
  ASSERT_TRUE(pieces);
  FragmentJoiner joiner;
  for (std::size_t i = pieces->size(); i-- > 0;) {
    EXPECT_EQ((*pieces)[i], bytes_of("map.md", "fragment-" + std::to_string(i)));
    const auto whole = joiner.add((*pieces)[i]);
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->value_or(std::vector<std::byte>()), i == 0 ? *written : std::vector<std::byte>());
  }
}

/// The examples of patches.
class PatchExamples : public testing::Test {
 protected:
  static Mesh mesh_of(const std::string& which) {
    Mesh mesh;
    mesh.positions = line_of<float>("map.md", which + "-q");
    mesh.triangles = line_of<std::uint32_t>("map.md", which + "-faces");
    return mesh;
  }
  static Mesh colored_mesh_of(const std::string& which) {
    Mesh mesh = mesh_of(which);
    mesh.attributes.push_back({.kind = AttributeKind::kColor,
                               .type = ComponentType::kU8,
                               .components = 3,
                               .normalized = true,
                               .values = colors_of(which + "-colours")});
    return mesh;
  }
  static std::vector<std::byte> colors_of(const std::string& name) {
    std::vector<std::byte> values;
    for (const auto level : line_of<std::uint8_t>("map.md", name)) values.push_back(std::byte{level});
    return values;
  }

  const Mesh base_ = colored_mesh_of("base");
  const Mesh new_ = colored_mesh_of("whole");
  const KnownMesh known_{base_.positions, base_.triangles, base_.attributes};
  const PredictiveParameters parameters_{
      .kind = PositionKind::kVoxel, .lattice = {.cells = {8, 8, 8}}, .levels = 2};
};

TEST_F(PatchExamples, MAP17ThePlan) {
  const Mesh inserted = mesh_of("new");
  const PatchPlan plan{line_of<std::uint8_t>("map.md", "kept"), line_of<std::uint32_t>("map.md", "joined")};
  const auto bytes = bytes_of("map.md", "plan");
  EXPECT_EQ(write_patch_plan(base_, inserted, plan), bytes);
  const auto read = read_patch_plan(bytes, base_, inserted);
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(read->stays, plan.stays);
  EXPECT_EQ(read->joins, plan.joins);
}

TEST_F(PatchExamples, MAP26MAP27MAP28MAP29MAP30TheGridAndItsColours) {
  const auto grid = bytes_of("map.md", "grid");
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < new_.positions.size(); i += 3) {
    cells.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis)
      cells.back()[axis] = static_cast<std::int32_t>(new_.positions[i + axis]);
  }
  const auto written = write_grid(new_.triangles, cells, parameters_, nullptr, &known_);
  ASSERT_TRUE(written);
  EXPECT_EQ(written->payloads.surface, grid);
  const auto read = read_grid({grid, {}}, parameters_, static_cast<std::uint32_t>(new_.vertex_count()),
                              static_cast<std::uint32_t>(new_.triangle_count()), {}, &known_);
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(read->triangles, new_.triangles);
  EXPECT_EQ(read->positions, new_.positions);

  auto payload = bytes_of("map.md", "colours");
  ASSERT_EQ(payload.front(), std::byte{7});
  payload.erase(payload.begin());
  AttributeSurface surface(new_.triangles, static_cast<std::uint32_t>(new_.vertex_count()), {},
                           new_.positions);
  surface.set_known(read->known);
  std::vector<std::uint32_t> order(new_.vertex_count());
  std::iota(order.begin(), order.end(), 0U);
  const AttributeView view = MeshView(new_).attributes[0];
  const auto colors =
      write_surface_colors(view.type, AttributeRows(view, order), 0, surface, nullptr, &base_.attributes[0]);
  ASSERT_TRUE(colors);
  EXPECT_EQ(colors->bytes, payload);
  const auto back =
      read_surface_colors(payload, view.type, view.components, surface, {}, &base_.attributes[0]);
  ASSERT_TRUE(back) << describe(back.error());
  EXPECT_EQ(*back, new_.attributes[0].values);
}

}  // namespace
}  // namespace deltamesh
