// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/convergence.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace deltamesh {
namespace {

using settling::Convergence;
using settling::Progress;

/// Of 40 and 60 vertices.
Components two_components() {
  Components components;
  components.count = 2;
  components.label.assign(40, 0);
  components.label.resize(100, 1);
  components.size = {40, 60};
  return components;
}

/// As many in each.
std::vector<std::uint32_t> anchors_of_both(std::uint32_t count) {
  std::vector<std::uint32_t> anchors;
  for (std::uint32_t a = 0; a < count; ++a) anchors.insert(anchors.end(), {a, 40 + a});
  return anchors;
}

const std::vector<std::uint32_t> kAnchors = anchors_of_both(32);

Progress good(double size) { return {.functional = 1, .decrease = size, .proposed = size, .mismatch = 0.1}; }

TEST(Convergence, AsksForStepsThatBecomeSmall) {
  const Components components = two_components();
  Convergence convergence(components, kAnchors);
  EXPECT_FALSE(convergence.see(std::vector<Progress>(2, good(1))));
  EXPECT_EQ(convergence.unsettled_vertices(), 100U);
  EXPECT_TRUE(convergence.see(std::vector<Progress>(2, good(0.01))));
  EXPECT_EQ(convergence.unsettled_vertices(), 0U);
}

/// One that falls slowly has much to come.
TEST(Convergence, AsksForMoreWhereStepsFallSlowly) {
  const Components components = two_components();
  Convergence convergence(components, kAnchors);
  convergence.see(std::vector<Progress>(2, good(0.0055)));
  EXPECT_FALSE(convergence.see(std::vector<Progress>{good(0.005), good(1e-6)}));
  EXPECT_EQ(convergence.unsettled_vertices(), 40U);
  EXPECT_EQ(convergence.unsettled(false), (std::vector<std::uint8_t>{1, 0}));
  EXPECT_EQ(convergence.unsettled(true), (std::vector<std::uint8_t>{0, 0}));
}

/// Where there are few, chance may have made the functional large.
TEST(Convergence, AsksForMoreOfFewAnchors) {
  const Components components = two_components();
  Convergence few(components, anchors_of_both(1));
  few.see(std::vector<Progress>(2, good(1)));
  EXPECT_FALSE(few.see(std::vector<Progress>(2, good(0.01))));
  EXPECT_TRUE(few.see(std::vector<Progress>(2, good(0.001))));
}

/// A step of no length tells nothing: what was proposed does.
TEST(Convergence, DoesNotTrustStepsThatAreHardlyTaken) {
  const Components components = two_components();
  Convergence convergence(components, kAnchors);
  const Progress stuck{.functional = 1, .decrease = 1e-12, .proposed = 0.5, .mismatch = 0.999};
  EXPECT_FALSE(convergence.see(std::vector<Progress>{good(1e-9), stuck}));
  EXPECT_FALSE(convergence.see(std::vector<Progress>{good(1e-9), stuck}));
  EXPECT_EQ(convergence.unsettled(true), (std::vector<std::uint8_t>{0, 1}));
}

TEST(Convergence, NotANumberIsNotSettled) {
  const Components components = two_components();
  Convergence convergence(components, kAnchors);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(convergence.see(std::vector<Progress>{good(1e-9), good(nan)}));
  EXPECT_FALSE(convergence.see(std::vector<Progress>{good(1e-9), good(nan)}));
  EXPECT_EQ(convergence.unsettled(true), (std::vector<std::uint8_t>{0, 1}));
}

}  // namespace
}  // namespace deltamesh
