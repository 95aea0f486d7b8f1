// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The coded border of a part.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "entropy/coder/writer.h"
#include "lattice/border_payload.h"
#include "lattice/place_border.h"
#include "lattice/source_colors.h"
#include "map/map_meshes.h"
#include "support/color_value.h"

namespace deltamesh {
namespace {

const MapLattice kLattice{.step_exponent = -8};
const BorderModels kFresh;

std::vector<BorderVertex> every_third(const Mesh& mesh, std::int32_t off) {
  std::vector<BorderVertex> border;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); v += 3) {
    const float* p = mesh.positions.data() + 3 * std::size_t{v};
    LatticePoint point = kLattice.nearest({p[0], p[1], p[2]});
    point[v % 2] += off;
    border.push_back({v, point, v % 5 == 0 ? v : 0});
  }
  return border;
}

BorderView view_of(const Mesh& mesh, bool follows) {
  BorderView view{{}, std::vector<std::uint8_t>(mesh.vertex_count(), 5), follows};
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const float* p = mesh.positions.data() + 3 * v;
    view.nearest.push_back(kLattice.nearest({p[0], p[1], p[2]}));
  }
  return view;
}

TEST(MapBorder, MAP11RoundTrip) {
  Mesh mesh = test::wavy_sheet(9, 7, 1, 0);
  for (const bool follows : {false, true}) {
    for (const std::int32_t off : {0, 1, -3000, 100000}) {
      const auto border = every_third(mesh, off);
      const auto bytes = write_border(mesh, view_of(mesh, follows), border, {}, {});
      const auto back = read_border(bytes, mesh, view_of(mesh, follows), {&kFresh});
      ASSERT_TRUE(back);
      EXPECT_EQ(*back, border);
    }
  }
  EXPECT_TRUE(write_border(mesh, view_of(mesh, false), {}, {}, {}).empty());
  EXPECT_TRUE(read_border({}, mesh, view_of(mesh, false), {&kFresh})->empty());
}

/// Every third vertex is of the base's border, of which every second has another point now; of the others
/// every second has not moved, and some are new on the border.
TEST(MapBorder, MAP11BesideABaseWhatIsUnmovedTakesLittle) {
  Mesh mesh = test::wavy_sheet(40, 30, 1, 0);
  const auto base = every_third(mesh, 900);
  BorderView view = view_of(mesh, false);
  view.base_border = base;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v)
    view.former.push_back(v % 3 == 0 ? v / 3 : v % 2 == 0 ? BorderView::kUnmoved : BorderView::kMoved);
  const auto bytes_of = [&](const std::vector<BorderVertex>& border, const BorderView& seen) {
    const auto bytes = write_border(mesh, seen, border, {}, {});
    const auto back = read_border(bytes, mesh, seen, {&kFresh});
    EXPECT_TRUE(back && *back == border);
    return bytes.size();
  };
  EXPECT_LT(10 * bytes_of(base, view), bytes_of(base, view_of(mesh, false)));
  auto other = base;
  for (std::size_t i = 0; i < other.size(); i += 2) other[i].point[1] += 5;
  for (std::size_t i = 1; i < other.size(); i += 4) other[i].twin += 1;
  for (std::uint32_t v = 1; v < mesh.vertex_count(); v += 30) other.push_back({v, base.front().point, 0});
  std::ranges::sort(other, {}, &BorderVertex::vertex);
  bytes_of(other, view);
}

TEST(MapBorder, MAP11RefusesABorderOfNothingAndPointsBeyondTheLattice) {
  Mesh mesh = test::wavy_sheet(9, 7, 1, 0);
  const OpenEdges edges(mesh.triangles, mesh.vertex_count());
  const BorderView view = view_of(mesh, false);
  CompactWriter nothing;
  BorderModels models;
  BorderCoder coder(nothing, models, view, edges);
  std::vector<BorderVertex> border;
  std::size_t next = 0;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) coder.code(v, border, next);
  EXPECT_STREQ(read_border(nothing.finish(), mesh, view_of(mesh, false), {&kFresh}).error().rule, "MAP-11");

  CompactWriter beyond;
  models = {};
  BorderCoder far(beyond, models, view, edges);
  border = {{0, {kMostLatticeSteps, 0, 0}, 0}};
  next = 0;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) far.code(v, border, next);
  Mesh moved = mesh;
  for (float& x : moved.positions) x += 1;  // so that the point is farther on
  EXPECT_STREQ(read_border(beyond.finish(), moved, view_of(moved, false), {&kFresh}).error().rule, "MAP-11");
}

/// A sheet whose colours, 4 components of this type, are what streams are off by.
Mesh painted_sheet(ComponentType type, std::uint32_t seed) {
  Mesh mesh = test::wavy_sheet(9, 7, 1, 0);
  const std::size_t size = component_size(type);
  Attribute colors{.kind = AttributeKind::kColor, .type = type, .components = 4, .normalized = true};
  colors.values.resize(4 * size * mesh.vertex_count());
  std::mt19937 random(seed);
  for (std::size_t i = 0; i < 4 * mesh.vertex_count(); ++i)
    store_component(&colors.values[i * size], size,
                    color_of_level(type, 8, static_cast<std::int32_t>((37 * i + random() % 9) % 256)));
  mesh.attributes = {std::move(colors)};
  return mesh;
}

TEST(MapBorder, MAP24CopiesGetOneColourWhateverTheirStreamsHave) {
  for (const ComponentType type : {ComponentType::kU8, ComponentType::kU16, ComponentType::kF32}) {
    for (const std::uint32_t step : {1U, 2U, 7U, 24U, 255U}) {
      const Mesh source = painted_sheet(type, 1);
      const std::size_t size = component_size(type);
      const auto border = every_third(source, 0);
      BorderColors wanted{.step = step};
      for (const BorderVertex& b : border)
        for (std::size_t c = 0; c < 4; ++c)
          wanted.levels.push_back(color_level(type, &source.attributes[0].values[(4 * b.vertex + c) * size]));
      for (const std::uint32_t seed : {2U, 3U}) {
        const Mesh decoded = painted_sheet(type, seed);
        Mesh written = decoded;
        Mesh read = decoded;
        const auto bytes = write_border(written, view_of(written, false), border, {}, {&wanted, 1});
        ASSERT_TRUE(read_border(bytes, read, view_of(read, false), {&kFresh}));
        EXPECT_EQ(read.attributes[0].values, written.attributes[0].values);
        for (std::uint32_t v = 0; v < read.vertex_count(); ++v)
          for (std::size_t c = 0; c < 4; ++c) {
            const auto level = [&](const Mesh& mesh) {
              return color_level(type, &mesh.attributes[0].values[(4 * v + c) * size]);
            };
            EXPECT_EQ(level(read), v % 3 == 0 ? border_level(level(source), step) : level(decoded));
          }
      }
    }
  }
}

TEST(MapBorder, RoundingIsOffByAMeanErrorAtMost) {
  for (const double rms : {0.3, 1.0, 2.27, 5.09, 40.0}) {
    for (const ComponentType type : {ComponentType::kU8, ComponentType::kF32}) {
      const auto step = static_cast<std::int32_t>(border_step(type, {.color_rms = rms}));
      std::int32_t most = 0;
      for (std::int32_t level = 0; step > 0 && level < 256; ++level)
        most = std::max(
            most, std::abs(border_level(static_cast<std::uint8_t>(level), static_cast<std::uint32_t>(step)) -
                           level));
      const double of_levels = type == ComponentType::kU8 || step == 0 ? 0 : 0.5;  // values are in between
      EXPECT_LE(most + of_levels, rms);
      EXPECT_GE(2 * (most + of_levels) + 2, std::min(2 * rms, 24.0)) << "a coarser step would do";
    }
  }
}

TEST(MapBorder, MAP24RefusesStepsAbove255) {
  Mesh mesh = painted_sheet(ComponentType::kU8, 1);
  const auto border = every_third(mesh, 0);
  const OpenEdges edges(mesh.triangles, mesh.vertex_count());
  const BorderView view = view_of(mesh, false);
  CompactWriter writer;
  BorderModels models;
  BorderCoder coder(writer, models, view, edges);
  auto coded = border;
  std::size_t next = 0;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) coder.code(v, coded, next);
  writer.number(256, models.colors.step);
  EXPECT_STREQ(read_border(writer.finish(), mesh, view, {&kFresh}).error().rule, "MAP-24");
}

TEST(MapBorder, AnyBytesGiveAnErrorOrABorder) {
  Mesh mesh = painted_sheet(ComponentType::kU8, 1);
  const auto border = every_third(mesh, 2);
  const BorderColors colors{.step = 7, .levels = std::vector<std::uint8_t>(4 * border.size(), 99)};
  const auto bytes = write_border(mesh, view_of(mesh, false), border, {}, {&colors, 1});
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    auto damaged = bytes;
    damaged[random() % damaged.size()] = static_cast<std::byte>(random() % 256);
    if (i % 2 == 0) damaged.resize(random() % damaged.size());
    const auto back = read_border(damaged, mesh, view_of(mesh, false), {&kFresh});
    if (!back) continue;
    for (const BorderVertex& b : *back) EXPECT_LT(b.vertex, mesh.vertex_count());
  }
}

TEST(MapBorder, MAP20WhatIsNearTheBorderMovesAlong) {
  // A strip of 60 x 2 squares whose first column is the border, 3 steps up from where it was decoded; the
  // vertex 1 has a copy that only the last face uses.
  Mesh mesh = test::wavy_sheet(60, 2, 1, 0);
  mesh.attributes.clear();
  const auto copy = static_cast<std::uint32_t>(mesh.vertex_count());
  for (std::size_t k = 0; k < 3; ++k) mesh.positions.push_back(mesh.positions[3 + k]);
  mesh.triangles.insert(mesh.triangles.end(), {copy, 63, 64});
  std::vector<BorderVertex> border;
  for (const std::uint32_t v : {0U, 61U, 122U}) {
    const float* p = mesh.positions.data() + 3 * std::size_t{v};
    LatticePoint point = kLattice.nearest({p[0], p[1], p[2]});
    point[2] += 3;
    border.push_back({v, point, 0});
  }
  const auto rise = [&](const Mesh& moved, std::size_t v) {
    return double{moved.positions[3 * v + 2]} - double{mesh.positions[3 * v + 2]};
  };
  Mesh still = mesh;
  place_border(still, border, kLattice, false);
  Mesh moved = mesh;
  place_border(moved, border, kLattice, true);
  for (const BorderVertex& b : border)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(moved.positions[3 * std::size_t{b.vertex} + k], kLattice.position_of(b.point)[k]);
  for (std::size_t v = 1; v < 30; ++v) {
    EXPECT_EQ(rise(still, v), 0);
    EXPECT_LE(rise(moved, v + 1), rise(moved, v) + 1e-7);
  }
  EXPECT_GT(rise(moved, 1), 0.7 * rise(moved, 0));
  EXPECT_EQ(rise(moved, 20), 0);  // 16 edges and no farther
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_EQ(moved.positions[3 * std::size_t{copy} + k], moved.positions[3 + k]);
}

}  // namespace
}  // namespace deltamesh
