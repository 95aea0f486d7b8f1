// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/numbers/portable_math.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/numbers/portable_math.h"
#include "base/simd/two_doubles.h"

namespace deltamesh {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(PortableMath, LogarithmsAreNearTheLibrarys) {
  for (const double x :
       {5e-324, 1e-310, 1e-20, 0.3, 0.70710678, 0.70710679, 0.999999, 1.0, 1.5, 3.0, 1e9, 1e308})
    EXPECT_NEAR(portable_log2(x), std::log2(x), 1e-9) << x;
  EXPECT_EQ(portable_log2(1), 0);
  EXPECT_EQ(portable_log2(0x1p-1074), -1074);
  EXPECT_EQ(portable_log2(0), -kInfinity);
  EXPECT_EQ(portable_log2(kInfinity), kInfinity);
  EXPECT_TRUE(std::isnan(portable_log2(-1)));
}

TEST(PortableMath, PowersAreNearTheLibrarys) {
  for (const double x : {-1000.3, -20.5, -0.5, -1e-9, 0.0, 0.25, 0.5, 7.7, 1000.9})
    EXPECT_NEAR(portable_exp2(x) / std::exp2(x), 1, 1e-13) << x;
  EXPECT_EQ(portable_exp2(10), 1024);
  EXPECT_EQ(portable_exp2(1e300), kInfinity);
  EXPECT_EQ(portable_exp2(-kInfinity), 0);
  EXPECT_TRUE(std::isnan(portable_exp2(std::nan(""))));
}

[[gnu::noinline]] TwoDoubles both_rounded(double a, double b) {
  return TwoDoubles{static_cast<double>(rounded(a)), static_cast<double>(rounded(b))};
}

TEST(PortableMath, RoundingToFloatsIsNeverLeftOut) {
  const TwoDoubles x = both_rounded(1.0 / 3, 1e-3);
  EXPECT_EQ(x[0], static_cast<double>(1.0F / 3));
  EXPECT_EQ(x[1], static_cast<double>(1e-3F));
}

TEST(PortableMath, BitsAreAlwaysTheSame) {
  EXPECT_EQ(std::bit_cast<std::uint64_t>(portable_log2(3)), 4609816855700301423U);
  EXPECT_EQ(std::bit_cast<std::uint64_t>(portable_log2(1e-3)), 13845171892708391573U);
  EXPECT_EQ(std::bit_cast<std::uint64_t>(portable_exp2(0.1)), 4607505657739150948U);
}

}  // namespace
}  // namespace deltamesh
