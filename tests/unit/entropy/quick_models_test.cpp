// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Quick models and numbers: intervals that make up the whole, numbers that come back, lanes as by hand.
#include "entropy/quick_models.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/eight_shorts.h"
#include "entropy/pair_reader.h"
#include "entropy/pair_writer.h"
#include "entropy/quick_number.h"
#include "support/random.h"

namespace deltamesh {
namespace {

constexpr std::array<std::uint8_t, 16> kWeights = {24, 14, 8, 4, 3, 2, 1, 3, 1, 2, 3, 4, 8, 14, 24, 40};

void expect_whole(const QuickModel& model) {
  std::uint32_t start = 0;
  for (unsigned s = 0; s < 16; ++s) {
    const Interval interval = model.interval(s);
    EXPECT_EQ(interval.start, start);
    EXPECT_GE(interval.size, 2U);
    start += interval.size;
    EXPECT_EQ(model.find(interval.start), s);
    EXPECT_EQ(model.find(start - 1), s);
  }
  EXPECT_EQ(start, 1U << 15);
}

TEST(QuickModels, CMP13IntervalsMakeUpTheWhole) {
  QuickModel model(kWeights);
  expect_whole(model);
  test::RandomBits random(3);
  for (const unsigned favourite : {0U, 7U, 15U}) {
    for (int i = 0; i < 20000; ++i) {
      model.learn(i % 300 == 0 ? random() % 16 : favourite);
      if (i % 499 == 0) expect_whole(model);
    }
    expect_whole(model);
    EXPECT_GT(model.interval(favourite).size, 31000U) << favourite;
  }
  EXPECT_EQ(model.interval(0).start, 0U);
}

TEST(QuickModels, CMP13LearnsAsByHand) {
  QuickModel model(kWeights);
  std::array<std::int32_t, 16> lanes{};
  std::int32_t below = 0;
  for (int i = 0; i < 16; ++i) {
    lanes[i] = 2 * i + below * 32482 / 155;
    below += kWeights[i];
  }
  test::RandomBits random(4);
  for (int n = 0; n < 400; ++n) {
    const unsigned symbol = random() % 16 / (1 + random() % 3);
    const int rate = n < 10 ? 3 : n < 26 ? 4 : n < 58 ? 5 : n < 122 ? 6 : n < 250 ? 7 : 8;
    for (int i = 0; i < 16; ++i)
      lanes[i] += (2 * i + (i > static_cast<int>(symbol) ? 32481 + (1 << rate) : 0) - lanes[i]) >> rate;
    model.learn(symbol);
    for (unsigned i = 0; i < 16; ++i) ASSERT_EQ(model.interval(i).start, lanes[i]) << n << " " << i;
  }
}

TEST(QuickNumbers, CMP14ReadsAnyNumber) {
  test::RandomBits random(5);
  std::vector<std::int64_t> numbers;
  for (int i = 0; i < 6000; ++i) {
    const auto size = static_cast<std::int64_t>(random() >> (random() % 31 + 1));
    numbers.push_back(random() % 2 == 0 ? size : -size);
  }
  const auto code = [&](auto& coder, std::vector<std::int64_t>& values) {
    QuickNumberCoder numbers_of(coder, 3, 2);
    for (std::size_t i = 0; i + 1 < values.size(); i += 2) {
      const auto shift = static_cast<unsigned>(i / 2 % 17);
      unsigned symbol = 0;
      values[i] = numbers_of.template code<0>(coder, values[i], shift, i % 3, i % 2, symbol);
      EXPECT_EQ(symbol == numbers_of.kEscape, values[i] >> shift < -7 || values[i] >> shift > 7);
      values[i + 1] = numbers_of.template code<1>(coder, values[i + 1], shift, i % 3, i % 2, symbol);
    }
  };
  PairWriter writer;
  code(writer, numbers);
  const PairBytes bytes(writer.finish());
  PairReader reader(bytes);
  std::vector<std::int64_t> back(numbers.size());
  code(reader, back);
  EXPECT_TRUE(reader.finish(0, 0));
  EXPECT_EQ(back, numbers);
}

TEST(PairReader, CMP3RefusesStatesOutOfRange) {
  for (const std::size_t size : {0, 4, 15}) {
    const PairBytes few(std::vector<std::byte>{size});
    const PairReader reader(few);
    EXPECT_TRUE(reader.failed());
    EXPECT_FALSE(reader.finish(0, 0));
  }
  std::vector<std::byte> bytes(16);
  const auto fails = [&] {
    const PairBytes of(bytes);
    return PairReader(of).failed();
  };
  EXPECT_TRUE(fails());
  bytes[3] = bytes[11] = std::byte{0x80};  // both 2^31: a stream without decisions
  EXPECT_FALSE(fails());
  const PairBytes whole(bytes);
  EXPECT_TRUE(PairReader(whole).finish(0, 0));
  bytes[15] = std::byte{0x80};
  EXPECT_TRUE(fails());
}

TEST(PairReader, CMP3MissesWords) {
  std::vector<std::byte> bytes(20);
  bytes[3] = bytes[11] = std::byte{0x80};
  const PairBytes one(bytes);
  PairReader reader(one);
  reader.bits<0>(0, 16);
  EXPECT_FALSE(reader.failed());
  for (std::size_t i = 1; i < PairBytes::kWordsUnasked; ++i) reader.bits<1>(0, 16);
  EXPECT_TRUE(reader.failed());
  EXPECT_FALSE(reader.finish(0, 0));
}

TEST(EightShorts, LanesAreAsByHand) {
  test::RandomBits random(6);
  for (int i = 0; i < 500; ++i) {
    EightShorts a;
    EightShorts b;
    for (int k = 0; k < 8; ++k) {
      a[k] = static_cast<std::int16_t>(random());
      b[k] = static_cast<std::int16_t>(random());
    }
    const EightShorts high = multiply_high(a, b);
    const EightShorts unsigned_high = multiply_high_unsigned(a, b);
    const FourInts sums_of_a = sums_of_halves(a, 8);
    const EightShorts octaves = quarter_octaves(a);
    const EightShorts positive_a = a & 0x7fff;
    const EightShorts positive_b = b & 0x7fff;
    const EightShorts means = rounded_means(positive_a, positive_b);
    const EightShorts sums = wrapped_sum(a, b);
    const EightShorts sizes = lane_sizes(larger_lanes(a, all_lanes(-32767)));
    const EightShorts low = low_halves(a, b);
    const EightShorts high_ones = high_halves(a, b);
    const EightShorts chosen = choose_lanes(a > b, a, b);
    for (int k = 0; k < 8; ++k) {
      EXPECT_EQ(high[k], (a[k] * b[k]) >> 16);
      EXPECT_EQ(static_cast<std::uint16_t>(unsigned_high[k]),
                (std::uint32_t{static_cast<std::uint16_t>(a[k])} * static_cast<std::uint16_t>(b[k])) >> 16);
      EXPECT_EQ(means[k], (positive_a[k] + positive_b[k] + 1) >> 1);
      EXPECT_EQ(sums[k], static_cast<std::int16_t>(a[k] + b[k]));
      EXPECT_EQ(sizes[k], std::min(std::abs(int{a[k]}), 32767));
      EXPECT_EQ(low[k], k < 4 ? a[k] : b[k - 4]);
      EXPECT_EQ(high_ones[k], k < 4 ? a[k + 4] : b[k]);
      const int half = k / 4 * 4;
      EXPECT_EQ(sums_of_a[k / 2], 8 * (a[half] + a[half + 1] + a[half + 2] + a[half + 3]));
      const std::uint32_t lane = static_cast<std::uint16_t>(a[k]);
      const auto place = static_cast<int>(std::bit_width(lane)) - 1;
      EXPECT_EQ(octaves[k], lane == 0 ? -4 * 127 : 4 * place + static_cast<int>((4 * lane >> place) & 3));
      EXPECT_EQ(chosen[k], std::max(a[k], b[k]));
    }
  }
}

}  // namespace
}  // namespace deltamesh
