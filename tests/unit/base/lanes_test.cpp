// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Vectors of numbers do what plain numbers do, on every machine.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/simd/eight_shorts.h"
#include "base/simd/four_ints.h"
#include "support/random.h"

namespace deltamesh {
namespace {

constexpr int kRounds = 2000;

FourInts random_ints(test::RandomBits& random, std::uint32_t range) {
  const auto number = [&] { return static_cast<std::int32_t>(random() % range); };
  return FourInts{number(), number(), number(), number()};
}

EightShorts random_shorts(test::RandomBits& random) {
  EightShorts lanes{};
  for (int i = 0; i < 8; ++i) lanes[i] = static_cast<std::int16_t>(random());
  return lanes;
}

TEST(Lanes, OfFourInts) {
  test::RandomBits random(1);
  for (int round = 0; round < kRounds; ++round) {
    const FourInts a = random_ints(random, 1U << 29);
    const FourInts b = random_ints(random, 1U << 30) - (1 << 29);
    const unsigned count = 1 + random() % 6;
    const std::int32_t third = (a[0] + a[1] + a[2]) / 3;
    std::array<std::int32_t, 3> three = {b[0], b[1], b[2]};
    const FourInts loaded = four_ints(three);
    store_three(a, three);
    EXPECT_EQ(three, (std::array<std::int32_t, 3>{a[0], a[1], a[2]}));
    EXPECT_EQ(loaded[3], 0);
    for (unsigned i = 0; i < 4; ++i) {
      EXPECT_EQ(loaded[i], i < 3 ? b[i] : 0);
      EXPECT_EQ(set_lanes(b) >> i & 1, b[i] < 0 ? 1U : 0U);
      EXPECT_EQ(mean_lanes(b, count)[i], (std::int64_t{b[i]} * kOneOver[count]) >> 16);
      EXPECT_EQ(third_of_sum(FourInts{a[0], a[1], a[2], 0})[i], third);
      EXPECT_EQ(clamp_lanes(b, 1 << 20)[i], std::clamp<std::int32_t>(b[i], -(1 << 20), 1 << 20));
      EXPECT_EQ(lane_sizes(b)[i], std::abs(b[i]));
      EXPECT_EQ(to_floats(b)[i], static_cast<float>(b[i]));
    }
  }
}

std::array<std::int32_t, 4> numbers(FourInts lanes) {
  return std::bit_cast<std::array<std::int32_t, 4>>(lanes);
}

TEST(Lanes, RoundToTheNearestAndToEven) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const FourInts ties = nearest_lanes(FourFloats{0.5F, 1.5F, -2.5F, 0x1.7fffffp+22F});
  EXPECT_EQ(numbers(ties), (std::array<std::int32_t, 4>{0, 2, -2, 0x600000}));
  const FourInts none = nearest_lanes(FourFloats{0x1p31F, -kInfinity, kInfinity, -0x1p31F});
  const FourInts doubles = nearest_lanes(TwoDoubles{0.5, -3.5}, TwoDoubles{2147483647.5, 2147483646.5});
  EXPECT_EQ(numbers(doubles), (std::array<std::int32_t, 4>{0, -4, INT32_MIN, 2147483646}));
  for (int i = 0; i < 4; ++i) EXPECT_EQ(none[i], INT32_MIN);
  test::RandomBits random(2);
  for (int round = 0; round < kRounds; ++round) {
    const auto bits = random() % 2 == 0 ? random() : random() % 0x4f000000;
    const auto x = std::bit_cast<float>(bits);
    if (std::isnan(x)) continue;
    const double whole = std::nearbyint(static_cast<double>(x));
    const std::int32_t nearest = std::abs(whole) < 0x1p31 ? static_cast<std::int32_t>(whole) : INT32_MIN;
    EXPECT_EQ(nearest_lanes(FourFloats{x, 0, 0, 0})[0], nearest) << x;
    EXPECT_EQ(nearest_lanes(TwoDoubles{0, double{x}}, TwoDoubles{})[1], nearest) << x;
  }
}

TEST(Lanes, SquareRootsAreRoundedAsOthersAre) {
  test::RandomBits random(3);
  for (int round = 0; round < kRounds; ++round) {
    const auto x = std::bit_cast<float>(random() % 0x7f800000);
    const double y = std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 900) - 450) + x;
    EXPECT_EQ(square_roots(FourFloats{0, x, 1, 2})[1], std::sqrt(x));
    EXPECT_EQ(square_roots(TwoDoubles{y, 4})[0], std::sqrt(y));
  }
}

TEST(Lanes, OfEightShorts) {
  test::RandomBits random(4);
  for (int round = 0; round < kRounds; ++round) {
    const EightShorts a = random_shorts(random);
    const EightShorts b = random_shorts(random);
    const FourInts low = random_ints(random, 1U << 17) - (1 << 16);
    const EightShorts packed = pack_lanes(low, -low);
    const unsigned set = set_lanes(a, b);
    for (int i = 0; i < 8; ++i) {
      const auto unsigned_of = [i](EightShorts lanes) {
        return std::uint32_t{static_cast<std::uint16_t>(lanes[i])};
      };
      EXPECT_EQ(packed[i], std::clamp(i < 4 ? low[i] : -low[i - 4], -0x8000, 0x7fff));
      EXPECT_EQ(set >> i & 1, a[i] < 0 ? 1U : 0U);
      EXPECT_EQ(set >> (8 + i) & 1, b[i] < 0 ? 1U : 0U);
      EXPECT_EQ(static_cast<std::uint16_t>(wrapped_difference(a, b)[i]),
                (unsigned_of(a) - unsigned_of(b)) & 0xffff);
    }
    for (int i = 0; i < 4; ++i) EXPECT_EQ(low_ints(a)[i], a[i]);
    const FourInts weighted = weighted_sums(a, b, in_turns(3, -7));
    const FourInts weighted_high = weighted_high_sums(a, b, in_turns(3, -7));
    for (int i = 0; i < 4; ++i) {
      EXPECT_EQ(weighted[i], 3 * a[i] - 7 * b[i]);
      EXPECT_EQ(weighted_high[i], 3 * a[4 + i] - 7 * b[4 + i]);
    }
  }
}

}  // namespace
}  // namespace deltamesh
