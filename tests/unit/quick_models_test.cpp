// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Quick models and numbers: intervals that make up the whole, numbers that come back, lanes as by hand.
#include "entropy/quick_models.h"

#include <gtest/gtest.h>

#include <array>
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

void expect_whole(const QuickModels& models, std::size_t model) {
  std::uint32_t start = 0;
  for (unsigned s = 0; s < 16; ++s) {
    const Interval interval = models.interval(model, s);
    EXPECT_EQ(interval.start, start);
    EXPECT_GE(interval.size, 2U);
    start += interval.size;
    EXPECT_EQ(models.find(model, interval.start), s);
    EXPECT_EQ(models.find(model, start - 1), s);
  }
  EXPECT_EQ(start, 1U << 15);
}

TEST(QuickModels, CMP13IntervalsMakeUpTheWhole) {
  QuickModels models(2, kWeights);
  expect_whole(models, 0);
  test::RandomBits random(3);
  for (const unsigned favourite : {0U, 7U, 15U}) {
    for (int i = 0; i < 20000; ++i) {
      models.learn(1, i % 300 == 0 ? random() % 16 : favourite);
      if (i % 499 == 0) expect_whole(models, 1);
    }
    expect_whole(models, 1);
    EXPECT_GT(models.interval(1, favourite).size, 31000U) << favourite;
  }
  EXPECT_EQ(models.interval(0, 0).start, 0U);
}

TEST(QuickModels, CMP13LearnsAsByHand) {
  QuickModels models(1, kWeights);
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
    models.learn(0, symbol);
    for (unsigned i = 0; i < 16; ++i) ASSERT_EQ(models.interval(0, i).start, lanes[i]) << n << " " << i;
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
      bool is_far = false;
      values[i] = numbers_of.template code<0>(coder, values[i], shift, i % 3, i % 2, is_far);
      EXPECT_EQ(is_far, values[i] >> shift < -7 || values[i] >> shift > 7);
      values[i + 1] = numbers_of.template code<1>(coder, values[i + 1], shift, i % 3, i % 2, is_far);
    }
  };
  PairWriter writer;
  code(writer, numbers);
  const auto bytes = writer.finish();
  PairReader reader(bytes);
  std::vector<std::int64_t> back(numbers.size());
  code(reader, back);
  EXPECT_TRUE(reader.finish(0, 0));
  EXPECT_EQ(back, numbers);
}

TEST(PairReader, CMP3RefusesStatesOutOfRange) {
  for (const std::size_t size : {0, 4, 15}) {
    const std::vector<std::byte> few(size);
    const PairReader reader(few);
    EXPECT_TRUE(reader.failed());
    EXPECT_FALSE(reader.finish(0, 0));
  }
  std::vector<std::byte> bytes(16);
  EXPECT_TRUE(PairReader(bytes).failed());
  bytes[3] = bytes[11] = std::byte{0x80};  // both 2^31: a stream without decisions
  EXPECT_TRUE(PairReader(bytes).finish(0, 0));
  bytes[15] = std::byte{0x80};
  EXPECT_TRUE(PairReader(bytes).failed());
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
    const FourInts sum = sum_of_upper(a, 8, b, -5);
    EXPECT_EQ(sum[1], 8 * (a[4] + a[5] + a[6] + a[7]) - 5 * (b[4] + b[5] + b[6] + b[7]));
    EXPECT_EQ(set_lanes(sum - sum[1] - 1), 15U);
    const EightShorts positive_a = a & 0x7fff;
    const EightShorts positive_b = b & 0x7fff;
    const EightShorts means = rounded_means(positive_a, positive_b);
    const EightShorts sums = wrapped_sum(a, b);
    const EightShorts sizes = lane_sizes(larger_lanes(a, all_lanes(-32767)));
    const EightShorts joined = join_halves(a, b);
    const EightShorts chosen = choose_lanes(a > b, a, b);
    for (int k = 0; k < 8; ++k) {
      EXPECT_EQ(high[k], (a[k] * b[k]) >> 16);
      EXPECT_EQ(static_cast<std::uint16_t>(unsigned_high[k]),
                (std::uint32_t{static_cast<std::uint16_t>(a[k])} * static_cast<std::uint16_t>(b[k])) >> 16);
      EXPECT_EQ(means[k], (positive_a[k] + positive_b[k] + 1) >> 1);
      EXPECT_EQ(sums[k], static_cast<std::int16_t>(a[k] + b[k]));
      EXPECT_EQ(sizes[k], std::min(std::abs(int{a[k]}), 32767));
      EXPECT_EQ(joined[k], k < 4 ? a[k] : b[k]);
      EXPECT_EQ(chosen[k], std::max(a[k], b[k]));
    }
  }
}

}  // namespace
}  // namespace deltamesh
