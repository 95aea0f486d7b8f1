// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/simd/four_ints.h"
#include "laplacian/multigrid/cycle/units.h"
#include "laplacian/operator/delta_view.h"

namespace deltamesh {
namespace {

constexpr std::int32_t kLeast = std::numeric_limits<std::int32_t>::min();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// What a symbol stands for, in units of step / 2^bits.
double expected(std::int32_t q, const DeltaScale& scale, int bits) {
  return std::ldexp(scale.value(q) / scale.step, bits);
}

TEST(FourInts, NearestLanesAreThoseOfTheEvenOneOfTwo) {
  const FourInts of_floats = nearest_lanes(FourFloats{0.5F, -1.5F, 2.5F, -0.49F});
  const std::array<std::int32_t, 4> ties = {0, -2, 2, 0};
  for (int i = 0; i < 4; ++i) EXPECT_EQ(of_floats[i], ties[static_cast<std::size_t>(i)]);
  const FourInts of_doubles = nearest_lanes(TwoDoubles{0.5, -1.5}, TwoDoubles{2147483646.5, -2147483648.4});
  const std::array<std::int32_t, 4> large = {0, -2, 2147483646, kLeast};
  for (int i = 0; i < 4; ++i) EXPECT_EQ(of_doubles[i], large[static_cast<std::size_t>(i)]);
}

TEST(FourInts, NearestLanesOfWhatHasNoneAreTheLeast) {
  const FourInts of_floats = nearest_lanes(FourFloats{0x1p31F, -0x1p32F, kNan, 1});
  EXPECT_EQ(of_floats[0], kLeast);
  EXPECT_EQ(of_floats[1], kLeast);
  EXPECT_EQ(of_floats[2], kLeast);
  EXPECT_EQ(of_floats[3], 1);
  const FourInts of_doubles = nearest_lanes(TwoDoubles{2147483647.5, -1e300}, TwoDoubles{double{kNan}, 7.0});
  EXPECT_EQ(of_doubles[0], kLeast);
  EXPECT_EQ(of_doubles[1], kLeast);
  EXPECT_EQ(of_doubles[2], kLeast);
  EXPECT_EQ(of_doubles[3], 7);
}

/// Exact from 8 bits on, the nearest below.
TEST(DeltaCounts, AreWhatSymbolsStandFor) {
  const std::vector<std::int32_t> symbols = {0, 1, -1, 2, -2, 255, -70000, 100, -3};
  const SymbolRows rows(symbols);
  for (const std::array<double, 3>& shifts :
       {std::array{0.0, 0.0, 0.0}, std::array{0.0, 31 / 256.0, 5 / 256.0},
        std::array{0.0, -127 / 256.0, 0.25}}) {
    const DeltaScale scale{.step = 0.003, .shifts = shifts};
    const DeltaView view(rows.view(), scale);
    for (const int bits : {0, 3, 7, 8, 9, 14}) {
      const DeltaCounts counts(view, bits);
      for (std::size_t i = 0; i < view.size(); ++i) {
        const auto lanes = reinterpret_cast<FourInts>(counts[i]);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double exact = expected(symbols[axis * view.size() + i], scale, bits);
          EXPECT_NEAR(lanes[static_cast<int>(axis)], exact, bits < 8 ? 0.5 + 1e-9 : 1e-6) << bits << ' ' << i;
        }
        EXPECT_EQ(lanes[3], 0);
      }
    }
  }
}

TEST(SymbolRows, AreTheSymbolsInAnyWidth) {
  for (const std::int32_t far :
       {0, 32767, -32768, 32768, -32769, kLeast, std::numeric_limits<std::int32_t>::max()}) {
    const std::vector<std::int32_t> planar = {1, -2, far, 3, 4, -5, 6, far, -7};
    const SymbolRows rows(planar);
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows.view().short_rows().empty(), far > 32767 || far < -32768);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(rows.view()[i][static_cast<int>(axis)], planar[3 * axis + i]);
      }
      EXPECT_EQ(rows.view()[i][3], 0);
    }
  }
}

TEST(DeltaCounts, TurnAroundBeyond32Bits) {
  const SymbolRows symbols(std::vector<std::int32_t>{3, kLeast, 0});
  const DeltaScale scale;
  const auto lanes =
      reinterpret_cast<FourInts>(DeltaCounts(DeltaView(symbols.view(), scale), DeltaCounts::kMostBits)[0]);
  EXPECT_EQ(lanes[0], -(1 << 30));  // 3 * 2^30 - 2^32
  EXPECT_EQ(lanes[1], 0);
}

TEST(DeltaCounts, OfDoublesAreTheNearest) {
  const std::vector<Vec3> deltas = {{0.3, -0.7, 1e-9}};
  const auto lanes = reinterpret_cast<FourInts>(DeltaCounts(deltas, 20)[0]);
  EXPECT_EQ(lanes[0], 314573);
  EXPECT_EQ(lanes[1], -734003);
  EXPECT_EQ(lanes[2], 0);
}

TEST(Units, KeepPositionsToTheirLastBit) {
  const SymbolRows symbols(std::vector<std::int32_t>{1, 2, 3});
  const DeltaScale scale{.step = 0.25};
  const multigrid::Units units(DeltaView(symbols.view(), scale), 1000);
  EXPECT_EQ(units.bits(), 26 - 9);
  const multigrid::Counts counts = units.count(multigrid::Float4{999.5F, -0.125F, 0, 0});
  const Vec3 position = units.position(counts);
  EXPECT_EQ(position[0], 0.25 * 999.5);
  EXPECT_EQ(position[1], 0.25 * -0.125);
  const multigrid::Float4 steps = units.steps(multigrid::Units::floats(counts));
  EXPECT_EQ(steps[0], 999.5F);
  EXPECT_EQ(steps[1], -0.125F);
}

TEST(Units, GiveNoPositionWhereTheStartIsNotFinite) {
  const SymbolRows symbols(std::vector<std::int32_t>{1, 2, 3});
  const DeltaScale scale;
  for (const float reach : {kNan, std::numeric_limits<float>::infinity()}) {
    const multigrid::Units units(DeltaView(symbols.view(), scale), reach);
    for (const multigrid::Float4 steps : {multigrid::Float4{}, multigrid::Float4{1, 2, 3, 0}})
      EXPECT_FALSE(std::isfinite(units.position(units.count(steps))[0]));
  }
}

}  // namespace
}  // namespace deltamesh
