// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "connectivity/order.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "base/byte_writer.h"
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

TEST(Order, RoundTrips) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const MeshOrder order = random_order(seed, seed * 31, seed * seed * 7);
    const std::vector<std::byte> payload = write_order(order);
    const auto read = read_order(payload, seed * 31, seed * seed * 7);
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(read->vertices, order.vertices);
    EXPECT_EQ(read->faces, order.faces);
    EXPECT_EQ(read->rotation, order.rotation);
  }
}

TEST(Order, ORDR1IdentityTakesThreeBytes) {
  MeshOrder order;
  order.vertices.resize(1000);
  std::iota(order.vertices.begin(), order.vertices.end(), 0U);
  order.faces = order.vertices;
  order.rotation.resize(1000, 0);
  EXPECT_EQ(write_order(order).size(), 3U);
}

TEST(Order, EveryPrefixAndExtensionFails) {
  std::vector<std::byte> payload = write_order(random_order(3, 300, 400));
  for (std::size_t size = 0; size < payload.size(); ++size) {
    const std::vector<std::byte> prefix(payload.begin(), payload.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_FALSE(read_order(prefix, 300, 400));
  }
  payload.push_back(std::byte{0});
  EXPECT_FALSE(read_order(payload, 300, 400));
}

void expect_rule(const Indices& vertices, const Indices& faces, const Indices& rotations, const char* rule) {
  ByteWriter out;
  write_planes(out, vertices);
  write_planes(out, faces);
  write_planes(out, rotations);
  const auto read = read_order(out.bytes(), 3, 2);
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

}  // namespace
}  // namespace deltamesh
