// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Colours beside those of a version that readers have.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include "attributes/attribute.h"
#include "attributes/colors/colors.h"
#include "support/graph_mesh.h"
#include "support/random.h"

namespace deltamesh {
namespace {

using Colors = std::vector<std::array<int, 3>>;

/// A sheet whose vertices had other colours before, but for every fifth, which had none.
struct Version {
  Version() {
    for (const Vec3& p : mesh.positions)
      for (const double x : p) positions.push_back(static_cast<float>(x));
    test::RandomBits random(3);
    const auto count = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::uint32_t v = 0; v < count; ++v) {
      const auto noise = [&] { return static_cast<int>(random() % 80); };
      const std::array<int, 3> was = {80 + noise(), 90 + noise(), 60 + noise()};
      former.push_back(was);
      const int change = v % 2 == 0 ? 3 : 17;
      colors.push_back({was[0] + change, was[1] + change, was[2] + change});
      known.push_back(v % 5 == 0 ? kNoKnownVertex : count - 1 - v);
    }
    std::vector<std::array<int, 3>> rows(former.rbegin(), former.rend());  // the version's own order
    attribute = {
        .kind = AttributeKind::kColor, .type = ComponentType::kU8, .components = 3, .values = bytes_of(rows)};
  }

  static std::vector<std::byte> bytes_of(const Colors& colors) {
    std::vector<std::byte> bytes;
    for (const auto& color : colors)
      for (const int level : color) bytes.push_back(static_cast<std::byte>(level));
    return bytes;
  }

  AttributeSurface surface(bool is_known) const {
    AttributeSurface of(mesh.triangles, static_cast<std::uint32_t>(colors.size()), {}, positions);
    if (is_known) of.set_known(known);
    return of;
  }

  std::optional<CodedValues<std::byte>> write(double bound, bool is_known, double former_error = 0) const {
    std::vector<std::uint32_t> order(colors.size());
    std::iota(order.begin(), order.end(), 0U);
    const std::vector<std::byte> values = bytes_of(colors);
    const AttributeView view{.type = ComponentType::kU8, .components = 3, .name = {}, .values = values};
    return write_surface_colors(ComponentType::kU8, AttributeRows(view, order), bound, surface(is_known),
                                nullptr, &attribute, former_error);
  }

  test::GraphMesh mesh = test::sheet(30, 30);
  std::vector<float> positions;
  Colors former;
  Colors colors;
  std::vector<std::uint32_t> known;
  Attribute attribute;
};

TEST(FormerColors, MAP30ColoursBesideFormerOnesKeepTheBoundInFewerBytes) {
  const Version version;
  for (const int bound : {0, 4}) {
    const auto alone = version.write(bound, false);
    const auto beside = version.write(bound, true);
    ASSERT_TRUE(alone && beside);
    EXPECT_LT(beside->bytes.size(), alone->bytes.size() * 9 / 10) << bound;
    const auto read = read_surface_colors(beside->bytes, ComponentType::kU8, 3, version.surface(true), {},
                                          &version.attribute);
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, beside->values);
    for (std::size_t v = 0; v < version.colors.size(); ++v)
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_LE(std::abs(std::to_integer<int>((*read)[3 * v + c]) - version.colors[v][c]), bound);
  }
}

/// What is off by more than the bound may stay as it was, and takes little then.
TEST(FormerColors, MAP30FormerColoursMayStayWhereTheyAreOffByMore) {
  const Version version;
  const auto strict = version.write(2, true);
  const auto loose = version.write(2, true, 17);
  ASSERT_TRUE(strict && loose);
  EXPECT_LT(2 * loose->bytes.size(), strict->bytes.size());
  const auto read =
      read_surface_colors(loose->bytes, ComponentType::kU8, 3, version.surface(true), {}, &version.attribute);
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, loose->values);
  for (std::size_t v = 0; v < version.colors.size(); ++v)
    for (std::size_t c = 0; c < 3; ++c) {
      const int now = std::to_integer<int>((*read)[3 * v + c]);
      if (v % 5 == 0)
        EXPECT_LE(std::abs(now - version.colors[v][c]), 2);
      else
        EXPECT_EQ(now, version.former[v][c]);
    }
}

TEST(FormerColors, MAP30WhatIsNotKnownChangesNothing) {
  const Version version;
  const std::vector<std::uint32_t> none(version.colors.size(), kNoKnownVertex);
  AttributeSurface surface = version.surface(false);
  surface.set_known(none);
  const auto alone = version.write(4, false);
  ASSERT_TRUE(alone);
  const auto read = read_surface_colors(alone->bytes, ComponentType::kU8, 3, surface, {}, &version.attribute);
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, alone->values);
}

TEST(FormerColors, MAP30ColoursOfAnotherShapeAreNotLookedAt) {
  const Version version;
  KnownMesh mesh{version.positions, version.mesh.triangles, std::span(&version.attribute, 1)};
  EXPECT_EQ(known_attribute(&mesh, 0, ComponentType::kU8, 3), &version.attribute);
  EXPECT_EQ(known_attribute(&mesh, 0, ComponentType::kU8, 4), nullptr);
  EXPECT_EQ(known_attribute(&mesh, 0, ComponentType::kU16, 3), nullptr);
  EXPECT_EQ(known_attribute(&mesh, 1, ComponentType::kU8, 3), nullptr);
  EXPECT_EQ(known_attribute(nullptr, 0, ComponentType::kU8, 3), nullptr);
  mesh.positions = mesh.positions.first(3);
  EXPECT_EQ(known_attribute(&mesh, 0, ComponentType::kU8, 3), nullptr);
}

}  // namespace
}  // namespace deltamesh
