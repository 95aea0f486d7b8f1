// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Blocks of mappers: what makes them fit together, and which are refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <random>
#include <span>
#include <string>

#include "deltamesh/map/block_adapter.h"
#include "deltamesh/map/sender.h"
#include "map/map_meshes.h"
#include "support/attribute_of.h"

namespace deltamesh {
namespace {

constexpr float kEdge = 0.05F;
constexpr int kQuads = 20;
using Floats = std::vector<float>;
using test::attribute_of;

/// Cells of one unit; colours and labels where asked for.
MapDescription adapter_map(bool has_values = false) {
  MapDescription description{.id = 42, .cell_steps = 512};
  description.lattice.step_exponent = -9;
  if (has_values)
    description.attributes = {{AttributeKind::kColor, ComponentType::kU8, 3, true, "color"},
                              {AttributeKind::kGeneric, ComponentType::kU8, 1, false, "label"}};
  return description;
}

/// In [-1, 1].
double noise_of(std::mt19937& random) { return static_cast<double>(random() % 2001) / 1000 - 1; }

/// The surface over the unit square whose low corner is at `x`; every position off by up to `noise`.
Mesh block_at(float x, double noise, std::uint32_t seed) {
  std::mt19937 random(seed);
  Mesh mesh;
  for (int row = 0; row <= kQuads; ++row) {
    for (int column = 0; column <= kQuads; ++column) {
      const double u = double{x} + double{kEdge} * column;
      const double v = double{kEdge} * row;
      for (const double c : {u, v, 0.1 * std::sin(3 * v)})
        mesh.positions.push_back(static_cast<float>(c + noise * noise_of(random)));
    }
  }
  for (std::uint32_t row = 0; row < kQuads; ++row) {
    for (std::uint32_t column = 0; column < kQuads; ++column) {
      const std::uint32_t a = row * (kQuads + 1) + column;
      for (const std::uint32_t corner : {a, a + 1, a + 21, a + 1, a + 22, a + 21})
        mesh.triangles.push_back(corner);
    }
  }
  return mesh;
}

/// Every corner a vertex of its own, each off by up to `noise`, without triangles.
Mesh soup_of(const Mesh& mesh, double noise) {
  std::mt19937 random(5);
  Mesh soup;
  for (const std::uint32_t v : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      soup.positions.push_back(
          static_cast<float>(double{mesh.positions[3 * v + k]} + noise * noise_of(random)));
  return soup;
}

Mesh one_triangle() {
  Mesh mesh;
  mesh.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  mesh.triangles = {0, 1, 2};
  return mesh;
}

BlockAdapter made(const MapDescription& description, const AdapterOptions& options = {}) {
  return std::move(*BlockAdapter::make(description, options));
}

/// Of all parts.
std::size_t border_vertices_of(std::span<const MapBlock> blocks) {
  auto splitter = Splitter::make(adapter_map(), {.most_level = 0});
  std::size_t count = 0;
  const auto change = splitter->update(blocks);
  EXPECT_TRUE(change);
  if (change)
    for (const ChangedPart& changed : change->changed) count += changed.part.border.size();
  return count;
}

TEST(MapAdapter, NearlyEqualBordersAreLinked) {
  const Mesh left = block_at(0, 1e-7, 1);
  const Mesh right = block_at(1, 1e-7, 2);
  const MapBlock blocks[] = {{{0, 0, 0}, left}, {{1, 0, 0}, right}};
  EXPECT_LT(border_vertices_of(blocks), 10U);  // a few are equal by chance
  BlockAdapter adapter = made(adapter_map());
  const auto adapted = adapter.update(blocks);
  ASSERT_TRUE(adapted);
  EXPECT_EQ(border_vertices_of(*adapted), 42U);
  EXPECT_EQ(adapter.counts().faces_dropped, 0U);
}

TEST(MapAdapter, BlocksThatComeAgainStayLinked) {
  BlockAdapter adapter = made(adapter_map());
  auto splitter = Splitter::make(adapter_map(), {.most_level = 0});
  std::map<PartKey, std::size_t> border;
  for (std::uint32_t i = 0; i < 20; ++i) {
    const std::int32_t x = static_cast<std::int32_t>(i % 2);
    const Mesh mesh = block_at(static_cast<float>(x), 1e-7, i);
    const MapBlock blocks[] = {{{x, 0, 0}, mesh}};
    const auto adapted = adapter.update(blocks);
    ASSERT_TRUE(adapted);
    const MeshView& now = adapted->front().mesh;
    ASSERT_EQ(now.vertex_count(), mesh.vertex_count());
    ASSERT_EQ(now.triangles.size(), mesh.triangles.size());
    for (std::size_t c = 0; c < mesh.triangles.size(); ++c)  // vertices come as faces first use them
      for (std::size_t k = 0; k < 3; ++k)
        ASSERT_NEAR(now.positions[3 * now.triangles[c] + k], mesh.positions[3 * mesh.triangles[c] + k],
                    1.0 / 512 / 16);
    const auto change = splitter->update(*adapted);
    ASSERT_TRUE(change);
    for (const ChangedPart& changed : change->changed) border[changed.part.key] = changed.part.border.size();
    if (i == 0) continue;
    EXPECT_EQ((border[{0, 0, 0, 0}]), 21U) << i;
    EXPECT_EQ((border[{0, 1, 0, 0}]), 21U) << i;
  }
}

TEST(MapAdapter, TheSenderTakesWhatItGives) {
  BlockAdapter adapter = made(adapter_map());
  auto sender = MapSender::make(adapter_map(), {.split = {.most_level = 0}});
  ASSERT_TRUE(sender);
  const Mesh left = soup_of(block_at(0, 0, 1), 1e-6);
  const Mesh right = soup_of(block_at(1, 0, 2), 1e-6);
  const MapBlock blocks[] = {{{0, 0, 0}, left}, {{1, 0, 0}, right}};
  ASSERT_TRUE(sender->update(*adapter.update(blocks)));
  ASSERT_EQ(sender->keys().size(), 2U);
  for (const PartKey& key : sender->keys()) {
    const MapPart& part = *sender->source(key);
    EXPECT_EQ(part.mesh.vertex_count(), 441U);
    EXPECT_EQ(part.mesh.triangle_count(), 800U);
    EXPECT_EQ(part.border.size(), 21U);
  }
  ASSERT_TRUE(sender->update(*adapter.clear()));
  EXPECT_TRUE(sender->keys().empty());
}

TEST(MapAdapter, SoupIsWelded) {
  const Mesh mesh = block_at(0, 0, 1);
  const Mesh soup = soup_of(mesh, 1e-6);
  ASSERT_EQ(soup.vertex_count(), 2400U);
  const MapBlock blocks[] = {{{0, 0, 0}, soup}};
  BlockAdapter adapter = made(adapter_map());
  const auto adapted = adapter.update(blocks);
  ASSERT_TRUE(adapted);
  EXPECT_EQ(adapted->front().mesh.vertex_count(), mesh.vertex_count());
  EXPECT_EQ(adapted->front().mesh.triangle_count(), mesh.triangle_count());
  EXPECT_EQ(adapter.counts().vertices_merged, 2400U - 441U);
  // Without a tolerance only equal positions are one.
  BlockAdapter exact = made(adapter_map(), {.tolerance = 0});
  EXPECT_GT(exact.update(blocks)->front().mesh.vertex_count(), 2000U);
  const Mesh clean = soup_of(mesh, 0);
  const MapBlock clean_blocks[] = {{{0, 0, 0}, clean}};
  EXPECT_EQ(exact.update(clean_blocks)->front().mesh.vertex_count(), mesh.vertex_count());
}

TEST(MapAdapter, FacesWithoutAreaAreDroppedAndTheirBlocksRemoved) {
  BlockAdapter adapter = made(adapter_map(), {.tolerance = 0.01});
  Mesh mesh = one_triangle();
  mesh.positions.insert(mesh.positions.end(), {1, 0.005F, 0});
  mesh.triangles.insert(mesh.triangles.end(), {0, 1, 3, 1, 3, 2});
  const MapBlock blocks[] = {{{0, 0, 0}, mesh}};
  const auto adapted = adapter.update(blocks);
  ASSERT_TRUE(adapted);
  EXPECT_EQ(adapted->front().mesh.triangle_count(), 1U);
  EXPECT_EQ(adapted->front().mesh.vertex_count(), 3U);
  EXPECT_EQ(adapter.counts().faces_dropped, 2U);

  mesh.triangles = {0, 1, 1};
  const MapBlock flat[] = {{{0, 0, 0}, mesh}};
  EXPECT_EQ(adapter.update(flat)->front().mesh.triangle_count(), 0U);
}

TEST(MapAdapter, RemovedBlocksKeepNoPositions) {
  BlockAdapter adapter = made(adapter_map(), {.tolerance = 0.01});
  const Mesh mesh = one_triangle();
  Mesh moved = mesh;
  moved.positions[0] = 0.005F;
  const MapBlock first[] = {{{0, 0, 0}, mesh}};
  const MapBlock second[] = {{{1, 0, 0}, moved}};
  ASSERT_TRUE(adapter.update(first));
  EXPECT_EQ(adapter.update(second)->front().mesh.positions[0], 0);
  const MapBlock none[] = {{{1, 0, 0}, {}}, {{0, 0, 0}, {}}, {{7, 0, 0}, {}}};
  EXPECT_EQ(adapter.update(none)->size(), 3U);
  EXPECT_EQ(adapter.update(second)->front().mesh.positions[0], 0.005F);
  // A block's own earlier version does not count.
  const MapBlock again[] = {{{1, 0, 0}, mesh}};
  EXPECT_EQ(adapter.update(again)->front().mesh.positions[0], 0);
}

TEST(MapAdapter, OrderOfBlocksIsNoMatter) {
  const Mesh left = block_at(0, 1e-6, 1);
  const Mesh right = block_at(1, 1e-6, 2);
  const MapBlock one[] = {{{0, 0, 0}, left}, {{1, 0, 0}, right}};
  const MapBlock two[] = {{{1, 0, 0}, right}, {{0, 0, 0}, left}};
  BlockAdapter a = made(adapter_map());
  BlockAdapter b = made(adapter_map());
  const auto from_one = a.update(one);
  const auto from_two = b.update(two);
  ASSERT_TRUE(from_one && from_two);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ((*from_one)[i].cell, (*from_two)[i].cell);
    EXPECT_TRUE(std::ranges::equal((*from_one)[i].mesh.positions, (*from_two)[i].mesh.positions));
    EXPECT_TRUE(std::ranges::equal((*from_one)[i].mesh.triangles, (*from_two)[i].mesh.triangles));
  }
}

TEST(MapAdapter, ValuesBecomeTheMaps) {
  Mesh mesh = one_triangle();
  mesh.attributes = {
      attribute_of(AttributeKind::kNormal, ComponentType::kF32, 3, "n", Floats{0, 0, 1, 0, 0, 1, 0, 0, 1}),
      attribute_of(AttributeKind::kGeneric, ComponentType::kI32, 1, "label",
                   std::vector<std::int32_t>{7, 0, 255}),
      attribute_of(AttributeKind::kColor, ComponentType::kF32, 4, "rgba",
                   Floats{0, 0.5F, 1, 1, 2, -1, 0.25F, 1, 1, 1, 1, 0})};
  const MapBlock blocks[] = {{{0, 0, 0}, mesh}};
  BlockAdapter adapter = made(adapter_map(true));
  const auto adapted = adapter.update(blocks);
  ASSERT_TRUE(adapted);
  const auto numbers = [](std::span<const std::byte> bytes) {
    std::vector<int> list;
    for (const std::byte b : bytes) list.push_back(std::to_integer<int>(b));
    return list;
  };
  const MeshView& view = adapted->front().mesh;
  ASSERT_EQ(view.attributes.size(), 2U);
  EXPECT_EQ(numbers(view.attributes[0].values), (std::vector<int>{0, 128, 255, 255, 0, 64, 255, 255, 255}));
  EXPECT_EQ(numbers(view.attributes[1].values), (std::vector<int>{7, 0, 255}));
  EXPECT_TRUE(Splitter::make(adapter_map(true))->update(*adapted));

  // 8 bits without alpha to floats with.
  MapDescription wide = adapter_map();
  wide.attributes = {{AttributeKind::kColor, ComponentType::kF32, 4, false, "c"}};
  mesh.attributes = {attribute_of(AttributeKind::kColor, ComponentType::kU8, 3, "",
                                  std::vector<std::uint8_t>{0, 51, 255, 0, 0, 0, 0, 0, 0})};
  const MapBlock bytes[] = {{{0, 0, 0}, mesh}};
  BlockAdapter widening = made(wide);
  const auto widened = widening.update(bytes);
  ASSERT_TRUE(widened);
  Floats first(4);
  std::memcpy(first.data(), widened->front().mesh.attributes[0].values.data(), 16);
  EXPECT_EQ(first, (Floats{0, 0.2F, 1, 1}));
}

/// The error of an update with this mesh as block -3 5 0.
Error refused_block(const MapDescription& description, const Mesh& mesh) {
  BlockAdapter adapter = made(description);
  const MapBlock blocks[] = {{{0, 0, 0}, {}}, {{-3, 5, 0}, mesh}};
  const auto adapted = adapter.update(blocks);
  EXPECT_FALSE(adapted);
  return adapted ? Error{} : adapted.error();
}

void expect_refused(const MapDescription& description, const Mesh& mesh, const std::string& message,
                    ErrorCode code = ErrorCode::kInvalidMesh) {
  const Error error = refused_block(description, mesh);
  EXPECT_EQ(error.code, code);
  EXPECT_EQ(std::string(error.found.data()), "block -3 5 0") << message;
  EXPECT_EQ(std::string(error.message), message);
}

TEST(MapAdapter, ErrorsNameTheBlockAndTheRule) {
  Mesh mesh = one_triangle();
  mesh.positions[4] = std::numeric_limits<float>::quiet_NaN();
  expect_refused(adapter_map(), mesh, "a coordinate is NaN or infinite", ErrorCode::kNotFinite);
  EXPECT_EQ(refused_block(adapter_map(), mesh).where, 1U);
  mesh = one_triangle();
  mesh.triangles[1] = 3;
  expect_refused(adapter_map(), mesh, "an index is not below the number of vertices");
  mesh.triangles.clear();
  mesh.positions.resize(6);
  expect_refused(adapter_map(), mesh, "a block without triangles has not three vertices for each");
  mesh = one_triangle();
  mesh.positions[0] = 1e9F;
  expect_refused(
      adapter_map(), mesh,
      "a position is 2^24 steps of the map's lattice or more from its origin; ask for a larger error",
      ErrorCode::kUnmetRequest);
  mesh = one_triangle();
  expect_refused(adapter_map(true), mesh, "the block lacks an attribute of the map");
  mesh.attributes = {
      attribute_of(AttributeKind::kGeneric, ComponentType::kF32, 1, "intensity", Floats{0, 0, 0})};
  expect_refused(adapter_map(), mesh, "the map has no such attribute");
  mesh.attributes = {attribute_of(AttributeKind::kColor, ComponentType::kF32, 3, "", Floats(9, 0)),
                     attribute_of(AttributeKind::kGeneric, ComponentType::kI32, 1, "label",
                                  std::vector<std::int32_t>{1, 256, 1})};
  expect_refused(adapter_map(true), mesh, "a value does not fit the type of the map's attribute");
  mesh.attributes[0] = attribute_of(AttributeKind::kColor, ComponentType::kF32, 3, "",
                                    Floats(9, std::numeric_limits<float>::quiet_NaN()));
  expect_refused(adapter_map(true), mesh, "a colour is NaN");
}

TEST(MapAdapter, AnErrorChangesNothing) {
  BlockAdapter adapter = made(adapter_map(), {.tolerance = 0.01});
  const Mesh mesh = one_triangle();
  Mesh moved = mesh;
  moved.positions[0] = 0.005F;
  Mesh broken = mesh;
  broken.triangles[0] = 9;
  const MapBlock first[] = {{{0, 0, 0}, mesh}};
  ASSERT_TRUE(adapter.update(first));
  const MapBlock bad[] = {{{0, 0, 0}, {}}, {{2, 0, 0}, broken}};
  EXPECT_FALSE(adapter.update(bad));
  const MapBlock twice[] = {{{0, 0, 0}, {}}, {{0, 0, 0}, mesh}};
  EXPECT_EQ(adapter.update(twice).error().code, ErrorCode::kInvalidArgument);
  const MapBlock second[] = {{{1, 0, 0}, moved}};
  EXPECT_EQ(adapter.update(second)->front().mesh.positions[0], 0);
  EXPECT_EQ(adapter.clear()->size(), 2U);
  EXPECT_TRUE(adapter.clear()->empty());
  EXPECT_EQ(adapter.update(second)->front().mesh.positions[0], 0.005F);
}

TEST(MapAdapter, TolerancesOutOfRangeAreRefused) {
  for (const double tolerance : {-1e-9, 0.51, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(BlockAdapter::make(adapter_map(), {.tolerance = tolerance}).error().code,
              ErrorCode::kInvalidArgument);
  EXPECT_TRUE(BlockAdapter::make(adapter_map(), {.tolerance = 0.5}));
}

}  // namespace
}  // namespace deltamesh
