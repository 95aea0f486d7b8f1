// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/lfe_fit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace deltamesh {
namespace {

double linear(double v) { return 0.3 * v + 0.7; }
double exponential(double v) { return 0.2 * std::exp(0.11 * v); }

TEST(LfeFit, IsLinearUpToFiveBits) {
  for (const double bits : {3.0, 4.0, 5.0})
    EXPECT_NEAR(density_for_lfe({5, linear(5)}, {9, linear(9)}, bits, linear(13)), 13, 1e-9);
}

TEST(LfeFit, IsExponentialFromSevenBits) {
  for (const double bits : {7.0, 8.0, 12.0})
    EXPECT_NEAR(density_for_lfe({5, exponential(5)}, {15, exponential(15)}, bits, exponential(10)), 10, 1e-9);
}

TEST(LfeFit, WeighsBothAtSixBits) {
  const DensityPair first{5, 2};
  const DensityPair second{15, 8};
  const double straight = density_for_lfe(first, second, 5, 4);
  const double curved = density_for_lfe(first, second, 7, 4);
  EXPECT_NE(straight, curved);
  EXPECT_NEAR(density_for_lfe(first, second, 6, 4), (straight + curved) / 2, 1e-12);
}

TEST(LfeFit, AnswersNoiseByProportionAndStaysInRange) {
  EXPECT_NEAR(density_for_lfe({10, 2}, {10, 3}, 6, 4), 20, 1e-12);
  EXPECT_NEAR(density_for_lfe({10, 2}, {12, 1}, 6, 1), 5, 1e-12);
  EXPECT_EQ(density_for_lfe({5, 1}, {6, 8}, 8, 1e-9), 1);
  EXPECT_EQ(density_for_lfe({5, 1}, {6, 2}, 4, 1e9), 65535);
}

}  // namespace
}  // namespace deltamesh
