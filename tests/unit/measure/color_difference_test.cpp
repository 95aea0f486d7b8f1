// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// CIEDE2000 of colours of a screen; the figures are those of an implementation that gives the data of Sharma,
// Wu and Dalal.
#include "measure/colors/color_difference.h"

#include <gtest/gtest.h>

#include <array>

namespace deltamesh {
namespace {

using Shown = std::array<double, 3>;

double between(const Shown& a, const Shown& b) {
  const auto share = [](const Shown& levels) {
    return Shown{levels[0] / 255, levels[1] / 255, levels[2] / 255};
  };
  const double difference = color_difference(share(a), share(b));
  EXPECT_NEAR(color_difference(share(b), share(a)), difference, 1e-9);
  return difference;
}

TEST(ColorDifference, IsThatOfCie) {
  EXPECT_EQ(between({12, 100, 200}, {12, 100, 200}), 0);
  EXPECT_NEAR(between({0, 0, 0}, {255, 255, 255}), 100, 1e-3);
  EXPECT_NEAR(between({255, 0, 0}, {0, 255, 0}), 86.6082, 1e-3);
  EXPECT_NEAR(between({255, 0, 0}, {0, 0, 255}), 52.8814, 1e-3);
  EXPECT_NEAR(between({120, 90, 60}, {124, 90, 60}), 1.5615, 1e-3);
  EXPECT_NEAR(between({30, 40, 200}, {33, 38, 203}), 0.5663, 1e-3);
  EXPECT_NEAR(between({200, 200, 200}, {200, 203, 200}), 2.5347, 1e-3);
  EXPECT_NEAR(between({9, 7, 4}, {7, 9, 4}), 1.9437, 1e-3);
  EXPECT_NEAR(between({250, 10, 20}, {250, 10, 5}), 1.6398, 1e-3);
}

}  // namespace
}  // namespace deltamesh
