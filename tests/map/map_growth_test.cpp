// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A map that grows, shrinks, begins empty or gets a stray vertex keeps its lattice and bounds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "deltamesh/map/encode_map.h"

namespace deltamesh::map_growth_test {
namespace {

/// A rough plain of `columns` x 40 vertices, 0.1 apart.
Mesh plain(std::uint32_t columns) {
  constexpr std::uint32_t kRows = 40;
  Mesh mesh;
  for (std::uint32_t x = 0; x < columns; ++x)
    for (std::uint32_t y = 0; y < kRows; ++y) {
      const auto u = static_cast<float>(x);
      const auto v = static_cast<float>(y);
      mesh.positions.insert(
          mesh.positions.end(),
          {0.1F * u, 0.1F * v, 0.2F * std::sin(u / 7) + 0.01F * std::sin(13 * u + 7 * v * v)});
      if (x == 0 || y == 0) continue;
      const std::uint32_t i = x * kRows + y;
      mesh.triangles.insert(mesh.triangles.end(), {i - kRows - 1, i - 1, i, i - kRows - 1, i, i - kRows});
    }
  return mesh;
}

MapSettings settings(const QualityRequest& bounds) {
  MapSettings settings;
  settings.part_edge = 2;
  settings.quality.bounds = bounds;
  return settings;
}

const QualityRequest kPercent{.max_error = QualityBound{.value = 0.02, .unit = QualityUnit::kDiagonal}};

/// How many parts of `after` are none of `before`.
std::size_t new_parts(const MapState& after) {
  return static_cast<std::size_t>(
      std::ranges::count(after.manifest.entries, after.manifest.revision, &PartEntry::revision));
}

TEST(MapGrowth, KeepsLatticeBoundsAndPartsThatDidNotChange) {
  for (const QualityRequest& bounds : {QualityRequest{}, kPercent}) {
    const auto before = encode_map(plain(60), settings(bounds));
    ASSERT_TRUE(before);
    EXPECT_TRUE(before->bounds.max_error);
    for (const std::uint32_t columns : {100U, 40U}) {
      const auto after = encode_map(plain(columns), settings(bounds), &*before);
      ASSERT_TRUE(after);
      EXPECT_EQ(after->manifest.description, before->manifest.description);
      EXPECT_EQ(after->bounds.max_error->value, before->bounds.max_error->value);
      EXPECT_LT(new_parts(*after), after->manifest.entries.size());
    }
  }
}

TEST(MapGrowth, AStrayVertexChangesThePartsAroundIt) {
  const auto before = encode_map(plain(60), settings({}));
  ASSERT_TRUE(before);
  Mesh mesh = plain(60);
  mesh.positions[3 * 100] = 1e4F;
  const auto after = encode_map(mesh, settings({}), &*before);
  ASSERT_TRUE(after) << describe(after.error());
  EXPECT_EQ(after->manifest.description, before->manifest.description);
  EXPECT_LT(new_parts(*after), after->manifest.entries.size());
}

TEST(MapGrowth, BeginsEmpty) {
  for (const QualityRequest& bounds : {QualityRequest{}, kPercent}) {
    const auto empty = encode_map(Mesh(), settings(bounds));
    ASSERT_TRUE(empty) << describe(empty.error());
    EXPECT_TRUE(empty->bounds.empty());
    const auto first = encode_map(plain(60), settings(bounds), &*empty);
    ASSERT_TRUE(first) << describe(first.error());
    const auto alone = encode_map(plain(60), settings(bounds));
    ASSERT_TRUE(alone);
    EXPECT_EQ(first->bounds.max_error->value, alone->bounds.max_error->value);
    const auto emptied = encode_map(Mesh(), settings(bounds), &*first);
    ASSERT_TRUE(emptied) << describe(emptied.error());
    EXPECT_EQ(emptied->manifest.description, first->manifest.description);
  }
}

TEST(MapGrowth, KeepsItsOrigin) {
  Mesh mesh = plain(60);
  mesh.origin = {500000, 5100000, 0};
  const auto before = encode_map(mesh, settings({}));
  ASSERT_TRUE(before);
  mesh = plain(100);  // as a reader places it: relative to another whole number
  mesh.origin = {500002, 5100000, 0};
  for (std::size_t i = 0; i < mesh.positions.size(); i += 3) mesh.positions[i] -= 2;
  const auto after = encode_map(mesh, settings({}), &*before);
  ASSERT_TRUE(after);
  EXPECT_EQ(after->manifest.description, before->manifest.description);
  EXPECT_LT(new_parts(*after), after->manifest.entries.size());
}

TEST(MapGrowth, OtherBoundsReplaceThoseFromBefore) {
  const QualityBound coarse{0.05};
  const QualityBound percent{.value = 0.02, .unit = QualityUnit::kDiagonal};
  const auto first = encode_map(plain(60), settings({.max_error = coarse}));
  ASSERT_TRUE(first);
  MapState state = *first;
  for (const QualityRequest& bounds :
       {kPercent, QualityRequest{.max_error = QualityBound{0.01}}, QualityRequest{.lfe = percent},
        QualityRequest{.vde = QualityBound{0.01}, .max_error = kNoBound}}) {
    const auto alone = encode_map(plain(60), settings(bounds));
    ASSERT_TRUE(alone);
    const auto after = encode_map(plain(60), settings(bounds), &state);
    ASSERT_TRUE(after);
    const auto kept = encode_map(plain(100), settings({}), &*after);  // nothing is said
    ASSERT_TRUE(kept);
    for (const MapState* now : {&*after, &*kept})
      for (const auto bound : {&QualityRequest::vde, &QualityRequest::lfe, &QualityRequest::max_error}) {
        ASSERT_EQ((now->bounds.*bound).has_value(), (bounds.*bound).has_value());
        if (!(bounds.*bound)) continue;
        EXPECT_EQ((now->bounds.*bound)->value, (alone->bounds.*bound)->value);
      }
    EXPECT_EQ(kept->manifest.description, after->manifest.description);
    state = *after;
  }
}

TEST(MapGrowth, AMapWithoutFacesRemembersWhatWasAsked) {
  const auto before = encode_map(plain(60), settings({.max_error = QualityBound{0.05}}));
  ASSERT_TRUE(before);
  const auto empty = encode_map(Mesh(), settings(kPercent), &*before);
  ASSERT_TRUE(empty);
  const auto after = encode_map(plain(60), settings({}), &*empty);
  const auto alone = encode_map(plain(60), settings(kPercent));
  ASSERT_TRUE(after && alone);
  EXPECT_EQ(after->bounds.max_error->value, alone->bounds.max_error->value);
}

}  // namespace
}  // namespace deltamesh::map_growth_test
