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

#include "base/byte_writer.h"
#include "connectivity/faces/faces.h"
#include "entropy/planes.h"
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

/// Both forms of what was written. Each is read from a copy, so that a sanitizer sees the bounds.
struct Form {
  std::vector<std::byte> bytes;
  bool is_compact;

  Result<MeshOrder> read(std::size_t size, const Indices& triangles, std::uint32_t vertices) const {
    const std::vector<std::byte> copy(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    return read_order(is_compact ? Payload::compact(copy) : Payload(copy), triangles, vertices);
  }
};
std::vector<Form> forms(const CodedOrder& coded) { return {{coded.payload, false}, {coded.compact, true}}; }

TEST(Order, RoundTrips) {
  std::uint32_t seed = 0;
  for (const test::Soup& soup : test::awkward_soups()) {
    const auto faces = static_cast<std::uint32_t>(soup.triangles.size() / 3);
    const MeshOrder order = random_order(seed++, soup.vertex_count, faces);
    for (const Form& form : forms(write_order(order, soup.triangles))) {
      const auto read = form.read(form.bytes.size(), soup.triangles, soup.vertex_count);
      ASSERT_TRUE(read) << soup.name << ": " << describe(read.error());
      EXPECT_EQ(read->vertices, order.vertices) << soup.name;
      EXPECT_EQ(read->faces, order.faces) << soup.name;
      EXPECT_EQ(read->rotation, order.rotation) << soup.name;
    }
  }
}

TEST(Order, ORDR1IdentityTakesThreeBytes) {
  MeshOrder order;
  order.vertices.resize(1000);
  std::iota(order.vertices.begin(), order.vertices.end(), 0U);
  order.faces = order.vertices;
  order.rotation.resize(1000, 0);
  EXPECT_EQ(write_order(order, test::random_soup(1, 1000, 1000).triangles).payload.size(), 3U);
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
  const CodedOrder coded = write_order(grid.order, grid.triangles);
  EXPECT_LT(coded.compact.size() * 8, coded.payload.size());
  EXPECT_LT(8 * coded.compact.size(), 4 * grid.order.faces.size()) << "bits";
}

TEST(Order, EveryPrefixAndExtensionFails) {
  const test::Soup soup = test::random_soup(3, 300, 400);
  for (Form form : forms(write_order(random_order(3, 300, 400), soup.triangles))) {
    for (std::size_t size = 0; size < form.bytes.size(); ++size)
      EXPECT_FALSE(form.read(size, soup.triangles, 300));
    form.bytes.push_back(std::byte{0});
    EXPECT_FALSE(form.read(form.bytes.size(), soup.triangles, 300));
  }
}

TEST(Order, FlippedBytesGiveAnErrorOrPermutations) {
  const GridInItsOrder grid;
  for (Form form : forms(write_order(grid.order, grid.triangles))) {
    for (std::size_t i = 0; i < form.bytes.size(); i += 1 + form.bytes.size() / 300) {
      form.bytes[i] ^= std::byte{0x21};
      const auto read = form.read(form.bytes.size(), grid.triangles, grid.vertices);
      form.bytes[i] ^= std::byte{0x21};
      if (!read) continue;
      Indices sorted = read->vertices;
      std::sort(sorted.begin(), sorted.end());
      for (std::uint32_t v = 0; v < sorted.size(); ++v) ASSERT_EQ(sorted[v], v);
    }
  }
}

const Indices kTwoFaces = {0, 1, 2, 2, 1, 0};

void expect_rule(const Indices& vertices, const Indices& faces, const Indices& rotations, const char* rule) {
  ByteWriter out;
  write_planes(out, vertices);
  write_planes(out, faces);
  write_planes(out, rotations);
  const auto read = read_order(out.bytes(), kTwoFaces, 3);
  ASSERT_FALSE(read);
  EXPECT_STREQ(read.error().rule, rule);
}

/// The same in compact form.
void expect_compact_rule(const Indices& vertices, const Indices& faces,
                         const std::vector<std::uint8_t>& rotations, const char* rule) {
  const std::vector<std::byte> bytes = write_order({vertices, faces, rotations}, kTwoFaces).compact;
  const auto read = read_order(Payload::compact(bytes), kTwoFaces, 3);
  ASSERT_FALSE(read);
  EXPECT_STREQ(read.error().rule, rule);
}

TEST(Order, ORDR2RejectsWhatIsNoPermutation) {
  expect_rule({0, 1, 0}, {0, 0}, {0, 0}, "ORDR-2");           // place 0 twice
  expect_rule({6, 0, 0}, {0, 0}, {0, 0}, "ORDR-2");           // place 3 of 3
  expect_rule({1, 0, 0}, {0, 0}, {0, 0}, "ORDR-2");           // place -1
  expect_rule({0, 0, 0}, {0, 1}, {0, 0}, "ORDR-2");           // a face twice
  expect_rule({0xffffffff, 0, 0}, {0, 0}, {0, 0}, "ORDR-2");  // far below
}

TEST(Order, ORDR3RejectsRotationsBeyondTwo) { expect_rule({0, 0, 0}, {0, 0}, {0, 3}, "ORDR-3"); }

TEST(Order, ORDR5RejectsWhatIsNoPermutation) {
  expect_compact_rule({0, 0, 1}, {0, 1}, {0, 0}, "ORDR-2");
  expect_compact_rule({0, 1, 3}, {0, 1}, {0, 0}, "ORDR-2");
  expect_compact_rule({0, 1, 0xffffffff}, {0, 1}, {0, 0}, "ORDR-2");
  expect_compact_rule({0, 1, 2}, {1, 1}, {0, 0}, "ORDR-2");
  expect_compact_rule({0, 1, 2}, {0, 2}, {0, 0}, "ORDR-2");
  expect_compact_rule({0, 1, 2}, {0, 1}, {0, 3}, "ORDR-3");
}

}  // namespace
}  // namespace deltamesh
