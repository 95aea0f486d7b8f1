// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "io/names.h"
#include "io/origin.h"

namespace deltamesh {
namespace {

TEST(PlaceOrigin, NearMeshesStayWhereTheyAre) {
  const std::vector<double> coordinates{0, 0, 10, 1, 1, 12, 3, 1, 11};
  const Mesh placed = place_origin(coordinates);
  EXPECT_EQ(placed.origin, (std::array<double, 3>{0, 0, 0}));
  EXPECT_EQ(placed.positions[5], 12.0F);
}

TEST(PlaceOrigin, Float32SourcesLoseNothing) {
  std::mt19937 random(7);
  for (const float centre : {100.0F, -5120000.0F, 465000.75F, 1e-3F, 16777216.0F, 3e30F}) {
    for (const float side : {std::fabs(centre) / 4.5F, std::fabs(centre) / 1000, 3.0F, 1.0F}) {
      std::vector<double> coordinates;
      std::uniform_real_distribution<float> inside(centre - side / 2, centre + side / 2);
      for (int i = 0; i < 300; ++i) coordinates.push_back(static_cast<double>(inside(random)));
      const Mesh placed = place_origin(coordinates);
      for (std::size_t i = 0; i < coordinates.size(); ++i)
        ASSERT_EQ(placed.origin[i % 3] + static_cast<double>(placed.positions[i]), coordinates[i]);
    }
  }
}

TEST(PlaceOrigin, OriginIsWholeForLargeMeshes) {
  const Mesh placed = place_origin(std::vector<double>{465000.3, 0, 0, 465003.4, 1, 1});
  EXPECT_EQ(placed.origin[0], std::round(placed.origin[0]));
  EXPECT_NEAR(placed.origin[0] + static_cast<double>(placed.positions[0]), 465000.3, 1e-6);
}

TEST(PlaceOrigin, NonFiniteAndHugeCoordinates) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Mesh placed = place_origin(std::vector<double>{1000, nan, 1e300, 1001, infinity, -1e300});
  EXPECT_EQ(placed.origin[1], 0);
  EXPECT_TRUE(std::isnan(placed.positions[1]));
  EXPECT_EQ(placed.positions[4], std::numeric_limits<float>::infinity());
  EXPECT_EQ(placed.positions[5], -std::numeric_limits<float>::infinity());
  EXPECT_TRUE(place_origin({}).positions.empty());
}

TEST(AttributeName, IsUtf8OfLimitedLength) {
  EXPECT_TRUE(is_attribute_name("confidence"));
  EXPECT_TRUE(is_attribute_name("Entfernung \xc3\xbc \xe2\x82\xac \xf0\x9f\x98\x80"));
  EXPECT_TRUE(is_attribute_name(std::string(255, 'a')));
  EXPECT_FALSE(is_attribute_name(std::string(256, 'a')));
  for (const char* name :
       {"", "\xff", "\xc3", "\xc0\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe0\x80\x80", "a\x80"})
    EXPECT_FALSE(is_attribute_name(name)) << name;
}

TEST(Origin, RoundingsAreWhatIsLost) {
  Imported imported;
  place_origin(std::vector<double>{0.1, 0.5, std::nan(""), 1e9 + 0.25, 1, 2, 0.2, 3, 4}, {}, imported);
  ASSERT_EQ(imported.roundings.size(), 9U);
  for (const std::size_t i : {6U, 7U, 8U})
    EXPECT_NEAR(imported.roundings[i] + double{imported.mesh.positions[i]} + imported.mesh.origin[i % 3],
                (std::array{0.2, 3.0, 4.0})[i - 6], 1e-15);
  EXPECT_EQ(imported.roundings[0], 0);  // of a vertex that is not finite
  EXPECT_GT(imported.report.position_error, 0);
  place_origin(std::vector<double>{0.5, 1, 2}, {}, imported);
  EXPECT_EQ(imported.report.position_error, 0);
  EXPECT_TRUE(imported.roundings.empty());
}

TEST(Origin, DoesNotHangOnVerticesThatNoFaceUses) {
  const std::vector<double> coordinates{1e8, 1e8, 1e8, 1e8 + 1, 1e8, 1e8, 1e8, 1e8 + 1, 1e8, 1e38, 0, 0};
  const std::vector<std::uint32_t> corners{0, 1, 2};
  Imported imported;
  place_origin(coordinates, corners, imported);
  EXPECT_EQ(imported.mesh.positions[3] - imported.mesh.positions[0], 1);
  EXPECT_EQ(imported.report.position_error, 0);
}

}  // namespace
}  // namespace deltamesh
