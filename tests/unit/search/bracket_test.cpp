// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/bracket.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace deltamesh {
namespace {

constexpr double kWithoutEnd = std::numeric_limits<double>::infinity();

struct Found {
  double setting = 0;
  bool kept = false;
  int trials = 0;
};

Found search(const BracketPlan& plan, const std::function<double(double)>& excess) {
  Bracket bracket(plan);
  Found found;
  while (!bracket.is_done() && found.trials < 100) {
    ++found.trials;
    bracket.tell(excess(bracket.setting()));
  }
  found.setting = bracket.best();
  found.kept = bracket.has_kept();
  return found;
}

/// An error that is proportional to the setting, of a bound of 1.
double proportional(double setting) { return excess_of_load(3 * setting); }

TEST(Bracket, ALineTakesTwoTrials) {
  for (const double first : {1e-6, 0.1, 0.3333, 1.0, 500.0}) {
    const Found found =
        search({.first = first, .aim = -0.03, .tolerance = -0.06, .trials = 20}, proportional);
    EXPECT_TRUE(found.kept);
    EXPECT_LE(3 * found.setting, 1);
    EXPECT_GE(3 * found.setting, 0.95);
    EXPECT_LE(found.trials, first < 0.01 || first > 2 ? 8 : 2) << first;
  }
}

TEST(Bracket, OtherSlopesAreLearnt) {
  for (const double power : {0.4, 0.7, 1.8}) {
    const auto excess = [power](double setting) { return excess_of_load(std::pow(setting, power)); };
    const Found found = search({.first = 0.05, .aim = -0.01, .tolerance = -0.02, .trials = 20}, excess);
    EXPECT_TRUE(found.kept);
    EXPECT_GE(excess(found.setting), -0.02);
    EXPECT_LE(found.trials, 6) << power;
  }
}

TEST(Bracket, ABudgetIsFilledFromBelow) {
  // Bytes of 1000 vertices: a bit less per coordinate where the step doubles.
  const auto bytes = [](double step) { return 200 + 375 * std::log2(1 + 1 / step); };
  for (const std::uint32_t budget : {400U, 1500U, 4000U}) {
    const auto excess = [&](double step) {
      return excess_of_bytes(static_cast<std::uint64_t>(bytes(step)), budget, 1000);
    };
    const Found found = search({.first = 0.1,
                                .least = 1e-9,
                                .most = 1e3,
                                .slope = -1,
                                .aim = -0.005,
                                .tolerance = -0.02,
                                .trials = 10},
                               excess);
    EXPECT_TRUE(found.kept);
    EXPECT_LE(bytes(found.setting), budget + 1.0);
    EXPECT_GE(bytes(found.setting), budget - 9.0);
    EXPECT_LE(found.trials, 5);
  }
}

/// At every rate, the settings of a budget being far from where the search begins.
TEST(Bracket, BytesOfASpreadAreForecastAtOnce) {
  const auto bytes = [](double step) { return 375 * std::log2(1 + 1 / step); };
  for (const double wanted : {1e-4, 0.02, 0.5, 3.0, 40.0}) {
    const auto budget = static_cast<std::uint64_t>(bytes(wanted));
    const Found found = search(
        {.first = 0.1, .slope = -1, .aim = -0.01, .tolerance = -0.05, .trials = 10},
        [&](double step) { return excess_of_bytes(static_cast<std::uint64_t>(bytes(step)), budget, 1000); });
    EXPECT_TRUE(found.kept);
    // Moves are three octaves at most.
    EXPECT_LE(found.trials, 3 + static_cast<int>(std::abs(std::log2(wanted / 0.1)) / 3)) << wanted;
  }
}

TEST(Bracket, WholeNumbersEndBetweenNeighbours) {
  for (const double first : {1.0, 5.0, 40.0, 900.0}) {
    // At least 37 levels keep the bound.
    const Found found =
        search({.first = first, .least = 1, .most = 1000, .whole = true, .slope = -1, .trials = 30},
               [](double levels) { return levels >= 37 ? -0.5 : 0.5; });
    EXPECT_TRUE(found.kept);
    EXPECT_EQ(found.setting, 37) << first;
    EXPECT_LE(found.trials, 14);
  }
}

TEST(Bracket, EndsAtTheLimits) {
  const Found loose =
      search({.first = 1, .least = 0.5, .most = 8, .trials = 20}, [](double) { return -5.0; });
  EXPECT_TRUE(loose.kept);
  EXPECT_EQ(loose.setting, 8);
  const Found tight = search({.first = 1, .least = 0.5, .most = 8, .trials = 20}, [](double) { return 5.0; });
  EXPECT_FALSE(tight.kept);
  EXPECT_EQ(tight.setting, 0.5);
}

TEST(Bracket, InfiniteExcessesBoundTheSearch) {
  // Above 2 nothing decodes; below 0.001 nothing is measurably wrong.
  const Found found =
      search({.first = 100, .aim = -0.03, .tolerance = -0.2, .trials = 20}, [](double setting) {
        return setting > 2 ? kWithoutEnd : setting < 0.001 ? -kWithoutEnd : excess_of_load(setting);
      });
  EXPECT_TRUE(found.kept);
  EXPECT_GE(found.setting, 0.8);
  EXPECT_LE(found.setting, 1);
}

TEST(Bracket, JumpsDoNotKeepItFromEnding) {
  // A largest error is a matter of chance.
  const auto excess = [](double setting) { return std::log2(setting) + 0.4 * std::sin(300 * setting); };
  for (const double first : {0.1, 0.9, 7.0}) {
    const Found found = search({.first = first, .aim = -0.03, .tolerance = -0.06, .trials = 8}, excess);
    EXPECT_TRUE(found.kept);
    EXPECT_LE(excess(found.setting), 0);
    EXPECT_LE(found.trials, 24);
  }
}

TEST(Bracket, GivesUpOnFloors) {
  const Found found = search({.first = 1, .trials = 4}, [](double) { return 0.7; });
  EXPECT_FALSE(found.kept);
  EXPECT_LE(found.trials, 12);
}

}  // namespace
}  // namespace deltamesh
