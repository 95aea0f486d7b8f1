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
using settling::Double4;
using settling::Progress;

constexpr std::uint32_t kAnchorsEach = 32;

/// Of 40 and 60 vertices.
Components two_components() {
  Components components;
  components.count = 2;
  components.label.assign(40, 0);
  components.label.resize(100, 1);
  components.size = {40, 60};
  return components;
}

Convergence make_convergence(const Components& components, double noise, double highest_rate = 0.98) {
  std::vector<std::uint32_t> anchors;
  for (const std::uint32_t first : {0U, 40U})
    for (std::uint32_t a = 0; a < kAnchorsEach; ++a) anchors.push_back(first + a);
  return {components, anchors, noise, highest_rate};
}

/// Of one axis and of the probe.
Double4 squares(double size, double probe_size) {
  return {TwoDoubles{size * size, 0}, TwoDoubles{0, probe_size * probe_size}};
}

/// Such that a delta's error is about 1 and moves a position by about 1: in the first component 0.73 may be
/// still to come, in the second 0.80.
Progress step(double size, double probe_size) {
  return {.functional = 3.0 * kAnchorsEach,
          .decrease = 0,
          .proposed = squares(size, probe_size),
          .taken = squares(size, probe_size),
          .probe = 50};
}

Progress step(double size) { return step(size, size); }

TEST(Convergence, AsksForStepsThatBecomeSmall) {
  const Components components = two_components();
  Convergence convergence = make_convergence(components, 1);
  EXPECT_FALSE(convergence.see(std::vector<Progress>(2, step(10))));
  EXPECT_EQ(convergence.unsettled_vertices(), 100U);
  EXPECT_TRUE(convergence.see(std::vector<Progress>(2, step(1))));
  EXPECT_EQ(convergence.unsettled_vertices(), 0U);
}

/// One that falls slowly has much to come.
TEST(Convergence, AsksForMoreWhereStepsFallSlowly) {
  const Components components = two_components();
  Convergence convergence = make_convergence(components, 1);
  convergence.see(std::vector<Progress>(2, step(1)));
  EXPECT_FALSE(convergence.see(std::vector<Progress>{step(0.9), step(0.01)}));
  EXPECT_EQ(convergence.unsettled_vertices(), 40U);
  EXPECT_EQ(convergence.unsettled(1), (std::vector<std::uint8_t>{1, 0}));
  EXPECT_EQ(convergence.unsettled(20), (std::vector<std::uint8_t>{0, 0}));
}

/// What x has hardly begun to move by shows in the probe.
TEST(Convergence, AsksForMoreWhereTheProbeMoves) {
  const Components components = two_components();
  Convergence convergence = make_convergence(components, 1);
  convergence.see(std::vector<Progress>{step(10, 10), step(10, 10)});
  EXPECT_FALSE(convergence.see(std::vector<Progress>{step(1, 1), step(1, 9.9)}));
  EXPECT_EQ(convergence.unsettled(1), (std::vector<std::uint8_t>{0, 1}));
}

/// Smaller errors are allowed less; how large they are is not known while the functional falls.
TEST(Convergence, AllowsAShareOfTheErrors) {
  const Components components = two_components();
  Convergence fine = make_convergence(components, 1e-4);
  fine.see(std::vector<Progress>(2, step(10)));
  EXPECT_FALSE(fine.see(std::vector<Progress>(2, step(1))));
  EXPECT_TRUE(fine.see(std::vector<Progress>(2, step(0.01))));
  Convergence falling = make_convergence(components, 1);
  Progress last = step(0.01);
  last.decrease = last.functional;
  falling.see(std::vector<Progress>(2, step(10)));
  EXPECT_FALSE(falling.see(std::vector<Progress>(2, last)));
}

/// A component that errors hardly move may be as wrong as the others.
TEST(Convergence, AllowsWhatTheMeanAllows) {
  const Components components = two_components();
  Convergence convergence = make_convergence(components, 1);
  Progress stiff = step(0.5);
  stiff.probe = 0;
  convergence.see(std::vector<Progress>(2, step(10)));
  EXPECT_TRUE(convergence.see(std::vector<Progress>{stiff, step(1)}));
}

/// Where a component is nearly exact, only the errors of others are allowed, in the mean.
TEST(Convergence, DoesNotTakeTheNoiseOfOthers) {
  const Components components = two_components();
  Convergence convergence = make_convergence(components, 1);
  Progress exact = step(0.5);
  exact.functional = 0;
  exact.probe = 1e6;
  convergence.see(std::vector<Progress>(2, step(10)));
  EXPECT_TRUE(convergence.see(std::vector<Progress>{exact, step(0.5)}));
  exact = step(5);
  exact.functional = 0;
  exact.probe = 1e6;
  EXPECT_FALSE(convergence.see(std::vector<Progress>{exact, step(0.5)}));
}

/// Rounding moves x by as much again at every step.
TEST(Convergence, BelievesInARateNoWorseThanTheHighest) {
  const Components components = two_components();
  Progress rounding = step(1e-9);
  rounding.functional = 0;
  for (const double highest_rate : {0.98, 0.5}) {
    Convergence convergence = make_convergence(components, 1, highest_rate);
    convergence.see(std::vector<Progress>(2, rounding));
    EXPECT_EQ(convergence.see(std::vector<Progress>(2, rounding)), highest_rate == 0.5);
  }
}

/// A step of no length tells nothing: what was proposed does.
TEST(Convergence, DoesNotTrustStepsThatAreHardlyTaken) {
  const Components components = two_components();
  Convergence convergence = make_convergence(components, 1);
  Progress stuck = step(5);
  stuck.taken = {};
  EXPECT_FALSE(convergence.see(std::vector<Progress>{step(1e-9), stuck}));
  EXPECT_FALSE(convergence.see(std::vector<Progress>{step(1e-9), stuck}));
  EXPECT_EQ(convergence.unsettled(5), (std::vector<std::uint8_t>{0, 1}));
}

TEST(Convergence, NotANumberIsNotSettled) {
  const Components components = two_components();
  Convergence convergence = make_convergence(components, 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(convergence.see(std::vector<Progress>{step(1e-9), step(nan)}));
  EXPECT_FALSE(convergence.see(std::vector<Progress>{step(1e-9), step(nan)}));
  EXPECT_EQ(convergence.unsettled(5), (std::vector<std::uint8_t>{0, 1}));
}

}  // namespace
}  // namespace deltamesh
