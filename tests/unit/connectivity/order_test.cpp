// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "connectivity/order/order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "connectivity/faces/faces.h"
#include "support/soups.h"

namespace deltamesh {
namespace {

using test::Indices;

MeshOrder random_order(std::uint32_t seed, std::uint32_t vertices, std::uint32_t faces) {
  test::Random random(seed);
  MeshOrder order;
  order.vertices.resize(vertices);
  order.faces.resize(faces);
  for (Indices* places : {&order.vertices, &order.faces}) {
    std::iota(places->begin(), places->end(), 0U);
    for (std::size_t i = places->size(); i > 1; --i)
      std::swap((*places)[i - 1], (*places)[random.below(static_cast<std::uint32_t>(i))]);
  }
  for (std::uint32_t f = 0; f < faces; ++f)
    order.rotation.push_back(static_cast<std::uint8_t>(random.below(3)));
  return order;
}

/// From a copy, so that a sanitizer sees the bounds.
Result<MeshOrder> read(std::span<const std::byte> bytes, const Indices& triangles, std::uint32_t vertices) {
  const std::vector<std::byte> copy(bytes.begin(), bytes.end());
  return read_order(copy, triangles, vertices);
}

TEST(Order, RoundTrips) {
  std::uint32_t seed = 0;
  for (const test::Soup& soup : test::awkward_soups()) {
    const auto faces = static_cast<std::uint32_t>(soup.triangles.size() / 3);
    const MeshOrder order = random_order(seed++, soup.vertex_count, faces);
    const auto back = read(write_order(order, soup.triangles), soup.triangles, soup.vertex_count);
    ASSERT_TRUE(back) << soup.name << ": " << describe(back.error());
    EXPECT_EQ(back->vertices, order.vertices) << soup.name;
    EXPECT_EQ(back->faces, order.faces) << soup.name;
    EXPECT_EQ(back->rotation, order.rotation) << soup.name;
  }
}

/// A grid whose vertices and faces are numbered row by row, coded from its middle outwards.
struct GridInItsOrder {
  GridInItsOrder() {
    const test::Soup grid = test::grid(kSide, kSide, false, false, 0, 1);
    const CodedConnectivity coded = write_connectivity(grid.triangles, grid.vertex_count);
    triangles = coded.triangles;
    vertices = grid.vertex_count;
    order = {coded.vertex_order, coded.face_order, coded.face_rotation};
  }
  static constexpr std::uint32_t kSide = 60;
  Indices triangles;
  std::uint32_t vertices;
  MeshOrder order;
};

TEST(Order, ORDR4ORDR6PlacesFollowFromNeighbors) {
  const GridInItsOrder grid;
  EXPECT_LT(8 * write_order(grid.order, grid.triangles).size(), 4 * grid.order.faces.size()) << "bits";
}

TEST(Order, EveryPrefixAndExtensionFails) {
  const test::Soup soup = test::random_soup(3, 300, 400);
  std::vector<std::byte> bytes = write_order(random_order(3, 300, 400), soup.triangles);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(read(std::span(bytes).first(size), soup.triangles, 300));
  bytes.push_back(std::byte{0});
  EXPECT_FALSE(read(bytes, soup.triangles, 300));
}

TEST(Order, FlippedBytesGiveAnErrorOrPermutations) {
  const GridInItsOrder grid;
  std::vector<std::byte> bytes = write_order(grid.order, grid.triangles);
  for (std::size_t i = 0; i < bytes.size(); i += 1 + bytes.size() / 300) {
    bytes[i] ^= std::byte{0x21};
    const auto back = read(bytes, grid.triangles, grid.vertices);
    bytes[i] ^= std::byte{0x21};
    if (!back) continue;
    Indices sorted = back->vertices;
    std::sort(sorted.begin(), sorted.end());
    for (std::uint32_t v = 0; v < sorted.size(); ++v) ASSERT_EQ(sorted[v], v);
  }
}

const Indices kTwoFaces = {0, 1, 2, 2, 1, 0};

void expect_rule(const Indices& vertices, const Indices& faces, const std::vector<std::uint8_t>& rotations,
                 const char* rule) {
  const auto back = read_order(write_order({vertices, faces, rotations}, kTwoFaces), kTwoFaces, 3);
  ASSERT_FALSE(back);
  EXPECT_STREQ(back.error().rule, rule);
}

TEST(Order, ORDR2ORDR5RejectsWhatIsNoPermutation) {
  expect_rule({0, 0, 1}, {0, 1}, {0, 0}, "ORDR-2");
  expect_rule({0, 1, 3}, {0, 1}, {0, 0}, "ORDR-2");
  expect_rule({0, 1, 0xffffffff}, {0, 1}, {0, 0}, "ORDR-2");
  expect_rule({0, 1, 2}, {1, 1}, {0, 0}, "ORDR-2");
  expect_rule({0, 1, 2}, {0, 2}, {0, 0}, "ORDR-2");
}

TEST(Order, ORDR3RejectsRotationsBeyondTwo) { expect_rule({0, 1, 2}, {0, 1}, {0, 3}, "ORDR-3"); }

}  // namespace
}  // namespace deltamesh
