// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "positions/guesses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <vector>

#include "support/random.h"

namespace deltamesh {
namespace {

/// The rule by the letter, on one axis.
std::vector<std::int32_t> guesses_by_the_letter(const std::vector<std::int32_t>& added,
                                                const std::vector<bool>& allowed, std::int64_t expected) {
  std::vector<std::int32_t> result;
  for (std::size_t i = 0; i < added.size(); ++i)
    if (allowed[i] && result.size() < Guesses::kMost &&
        std::find(result.begin(), result.end(), added[i]) == result.end())
      result.push_back(added[i]);
  std::stable_sort(result.begin(), result.end(), [&](std::int64_t a, std::int64_t b) {
    return std::llabs(a - expected) < std::llabs(b - expected);
  });
  return result;
}

void expect_as_written(const std::vector<std::array<std::int32_t, 3>>& added,
                       const std::vector<std::array<bool, 3>>& allowed,
                       const std::array<std::int32_t, 3>& expected) {
  Guesses guesses(four_ints(expected));
  for (std::size_t i = 0; i < added.size(); ++i)
    guesses.add(four_ints(added[i]), FourInts{-allowed[i][0], -allowed[i][1], -allowed[i][2], 0});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<std::int32_t> numbers;
    std::vector<bool> may_be;
    for (std::size_t i = 0; i < added.size(); ++i) {
      numbers.push_back(added[i][axis]);
      may_be.push_back(allowed[i][axis]);
    }
    const auto letter = guesses_by_the_letter(numbers, may_be, expected[axis]);
    ASSERT_EQ(guesses.count(axis), letter.size());
    for (unsigned place = 0; place < letter.size(); ++place) {
      EXPECT_EQ(guesses.at(axis, place), letter[place]);
      EXPECT_EQ(guesses.symbol_of(axis, letter[place]), place + 1);
    }
    for (const std::int32_t number : numbers)
      EXPECT_EQ(guesses.symbol_of(axis, number) != 0,
                std::find(letter.begin(), letter.end(), number) != letter.end());
  }
}

TEST(Guesses, FLT4AreDifferentAndTheNearestFirst) {
  test::RandomBits random(5);
  constexpr std::int32_t kLeast = std::numeric_limits<std::int32_t>::min();
  constexpr std::int32_t kLargest = std::numeric_limits<std::int32_t>::max();
  for (int round = 0; round < 3000; ++round) {
    const bool is_wide = round % 3 == 0;  // to the ends of the range, where differences take 33 bits
    const auto number = [&] {
      const auto bits = static_cast<std::uint32_t>(random());
      if (!is_wide) return static_cast<std::int32_t>(bits % 9);
      return bits % 5 == 0 ? kLeast : bits % 5 == 1 ? kLargest : static_cast<std::int32_t>(bits);
    };
    std::vector<std::array<std::int32_t, 3>> added(random() % (Guesses::kMostAdded + 1));
    std::vector<std::array<bool, 3>> allowed(added.size());
    for (auto& numbers : added) numbers = {number(), number(), number()};
    // Whether a number is allowed depends on it alone.
    const auto may_be = [&](std::int32_t n) { return is_wide || n != 4; };
    for (std::size_t i = 0; i < added.size(); ++i)
      allowed[i] = {may_be(added[i][0]), may_be(added[i][1]), may_be(added[i][2])};
    expect_as_written(added, allowed, {number(), number(), number()});
  }
}

}  // namespace
}  // namespace deltamesh
