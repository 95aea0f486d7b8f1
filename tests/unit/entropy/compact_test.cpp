// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include <algorithm>

#include "entropy/coder/reader.h"
#include "entropy/coder/split_number.h"
#include "entropy/coder/writer.h"
#include "support/random.h"

namespace deltamesh {
namespace {

constexpr std::uint32_t kTag = 0x54534554;

/// Some of everything the coder offers, drawn from a seed; the same calls write and read.
struct Script {
  struct Step {
    unsigned kind;
    std::uint32_t value;
    unsigned size;
  };
  std::vector<Step> steps;

  Script(std::uint32_t seed, std::size_t count) {
    test::RandomBits random(seed);
    for (std::size_t i = 0; i < count; ++i) {
      Step step{.kind = random() % 6, .value = random(), .size = random() % 33};
      if (step.kind < 2) step.value = random() % 3 == 0 ? random() % 16 : 7;
      if (step.kind == 2) step.value = random() % 10 == 0 ? 1 : 0;
      if (step.kind == 5) step.size %= kMostBitsAtOnce + 2;
      if (step.kind > 2) step.value = step.size == 0 ? 0 : step.value >> (32 - step.size);
      steps.push_back(step);
    }
  }

  /// Runs the script; returns what the coder answered.
  template <class Coder>
  std::vector<std::uint32_t> run(Coder& coder) const {
    constexpr SymbolModel kFresh({1, 1, 1, 1, 1, 1, 1, 9, 1, 1, 1, 1, 1, 1, 1, 1});
    std::array<SymbolModel, 3> models = {kFresh, kFresh, kFresh};
    MixWeights pair;
    BitModel bit;
    NumberModel number;
    SymbolBits inner;
    LowBits low;
    std::vector<std::uint32_t> answers;
    for (const Step& step : steps) {
      switch (step.kind) {
        case 0:
          answers.push_back(coder.symbol(step.value, Mixture<1>{{&models[0]}}));
          break;
        case 1:
          answers.push_back(coder.symbol(step.value, Mixture<2>{{&models[1], &models[2]}, &pair}));
          break;
        case 2:
          answers.push_back(coder.bit(step.value != 0, bit) ? 1 : 0);
          break;
        case 3:
          answers.push_back(coder.bits(step.value, step.size));
          break;
        case 4:
          answers.push_back(coder.number(step.value, number));
          break;
        default:
          low = {.count = step.size, .value = step.value};
          answers.push_back(
              coder.symbol_and_bits(step.size % 16, low, Mixture<2>{{&models[1], &models[2]}, &pair}, inner));
          answers.push_back(low.value);
      }
    }
    return answers;
  }
};

std::vector<std::byte> write(const Script& script) {
  CompactWriter writer;
  script.run(writer);
  return writer.finish();
}

/// A symbol with its bits takes as many states as one without.
TEST(Compact, CMP12IsOneStep) {
  constexpr SymbolModel kFresh({1, 1, 1, 1, 1, 1, 1, 9, 1, 1, 1, 1, 1, 1, 1, 1});
  CompactWriter writer;
  SymbolModel model = kFresh;
  SymbolBits inner;
  for (unsigned count = 0; count <= kMostBitsAtOnce + 1; ++count) {
    LowBits low{.count = count, .value = 0x15555U >> (17 - count)};
    writer.symbol_and_bits(7, low, Mixture<1>{{&model}}, inner);
    writer.bits(0, 0);
  }
  // The second state takes part in nothing but the empty symbols.
  const auto bytes = writer.finish();
  const std::size_t second = 1 + (std::to_integer<std::size_t>(bytes[0]) & 15);
  const bool is_long = std::to_integer<unsigned>(bytes[0]) >> 4 == 4;  // 2^31, else 2^15
  const std::vector<std::byte> untouched{
      bytes.begin() + static_cast<std::ptrdiff_t>(second),
      bytes.begin() + static_cast<std::ptrdiff_t>(second + (is_long ? 4 : 2))};
  EXPECT_EQ(untouched.back(), std::byte{0x80});
  EXPECT_EQ(std::count(untouched.begin(), untouched.end(), std::byte{0}), std::ssize(untouched) - 1);
}

TEST(Compact, CMP1ReadsWhatWasWritten) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    const Script script(seed, seed * 20);
    CompactWriter writer;
    const auto written = script.run(writer);
    const auto bytes = writer.finish();
    CompactReader reader(bytes);
    EXPECT_EQ(script.run(reader), written);
    EXPECT_TRUE(reader.finish(kTag)) << seed;
    EXPECT_EQ(write(script), bytes);
  }
}

TEST(Compact, CMP1AnEmptyStreamIsItsStates) {
  CompactWriter writer;
  const auto bytes = writer.finish();
  ASSERT_EQ(bytes.size(), 5U);
  EXPECT_TRUE(CompactReader(bytes).finish(kTag));
}

TEST(Compact, CMP1CMP3EveryPrefixAndExtensionFails) {
  const Script script(7, 100);
  const auto bytes = write(script);
  const auto sizes = std::to_integer<std::size_t>(bytes[0]);
  const std::size_t start = 1 + (sizes & 15) + (sizes >> 4);
  for (std::size_t size = 0; size <= bytes.size() + 4; ++size) {
    if (size == bytes.size()) continue;
    std::vector<std::byte> changed = bytes;
    changed.resize(size);
    CompactReader reader(changed);
    script.run(reader);
    const auto result = reader.finish(kTag);
    ASSERT_FALSE(result) << size;
    EXPECT_STREQ(result.error().rule, size < start ? "CMP-1" : "CMP-3");
    EXPECT_EQ(result.error().chunk_tag, kTag);
  }
}

TEST(Compact, CMP3FlippedBytesEndInAnErrorOrOtherSymbols) {
  const Script script(9, 60);
  const auto bytes = write(script);
  std::size_t passed = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      auto changed = bytes;
      changed[i] ^= static_cast<std::byte>(1U << bit);
      CompactReader reader(changed);
      script.run(reader);
      if (reader.finish(kTag)) ++passed;
    }
  }
  EXPECT_LT(passed, 4 * bytes.size());  // raw bits may change unnoticed
}

TEST(Compact, CMP1RejectsAStateOutOfRange) {
  for (const std::uint64_t state : {std::uint64_t{0}, kLeastState - 1, kRansFloor << 32, ~std::uint64_t{0}}) {
    for (const unsigned broken : {1U, 9U}) {
      std::vector<std::byte> bytes(17);
      bytes[0] = std::byte{0x88};
      for (const std::size_t b : {2U, 10U}) bytes[b] = std::byte{0x80};
      ASSERT_TRUE(CompactReader(bytes).finish(kTag));
      for (unsigned i = 0; i < 8; ++i) bytes[broken + i] = static_cast<std::byte>(state >> (8 * i));
      CompactReader reader(bytes);
      EXPECT_TRUE(reader.failed());
      EXPECT_FALSE(reader.finish(kTag));
    }
  }
}

TEST(Compact, CMP1RejectsStatesOfMoreThanEightBytes) {
  std::vector<std::byte> bytes(20);
  for (const unsigned sizes : {0x98U, 0x89U, 0xffU}) {
    bytes[0] = static_cast<std::byte>(sizes);
    EXPECT_TRUE(CompactReader(bytes).failed());
  }
}

/// Symbols of which one state has all that cost anything: the other is still small when words are due.
TEST(Compact, CMP3StatesEndHighWhereOneAloneGivesWords) {
  for (const unsigned costly : {0U, 1U}) {
    CompactWriter writer;
    for (unsigned i = 0; i < 40; ++i) writer.bits(i % 2 == costly ? i * 1601 : 0, i % 2 == costly ? 16 : 0);
    const auto bytes = writer.finish();
    CompactReader reader(bytes);
    for (unsigned i = 0; i < 40; ++i) {
      const std::uint32_t value = reader.bits(0, i % 2 == costly ? 16 : 0);
      ASSERT_EQ(value, i % 2 == costly ? i * 1601 : 0);
    }
    EXPECT_TRUE(reader.finish(kTag));
  }
}

TEST(Compact, CMP5LanesNeverFallAndEverySymbolStaysPossible) {
  test::RandomBits random(3);
  SymbolModel model({1, 1, 1, 1, 1, 1, 1, 9, 1, 1, 1, 1, 1, 1, 1, 1});
  for (int i = 0; i < 5000; ++i) {
    const LaneSum starts = Mixture<1>{{&model}}.starts();
    std::uint32_t sum = 0;
    for (unsigned s = 0; s < kSymbols; ++s) {
      const Interval interval = interval_of(starts, s);
      ASSERT_GE(interval.size, 2U);
      ASSERT_EQ(interval.start, sum);
      sum += interval.size;
    }
    ASSERT_EQ(sum, kProbabilityOne);
    model.learn(i < 1000 ? 0 : i < 2000 ? 15 : random() % 16);
  }
}

TEST(Compact, CMP6WeightsKeepTheirSum) {
  constexpr SymbolModel kFresh({1, 1, 1, 1, 1, 1, 1, 9, 1, 1, 1, 1, 1, 1, 1, 1});
  std::array<SymbolModel, 2> models = {kFresh, kFresh};
  MixWeights weights;
  const Mixture<2> mixture{{&models[0], &models[1]}, &weights};
  test::RandomBits random(5);
  // One model is right for long, then the other; some symbols no model expects.
  for (int i = 0; i < 40000; ++i) {
    const std::size_t right = (i / 3000) % 2;
    models[right].learn(3);
    models[1 - right].learn(12);
    const unsigned symbol = random() % 50 == 0 ? random() % 16 : 3;
    mixture.learn(symbol, interval_of(mixture.starts(), symbol).size);
    const auto [first, second] = weights.values();
    ASSERT_GE(std::min(first, second), 512U);
    ASSERT_EQ(first + second, 32994U);
    if (i % 3000 == 2999) {
      EXPECT_GT(weights.values()[right], 27000U);
    }
  }
}

TEST(Compact, CMP12BothInnerBitsStayPossible) {
  for (const bool bit : {false, true}) {
    InnerBit model;
    for (int i = 0; i < 3000; ++i) {
      for (const std::uint32_t whole : {2U, 3U, 100U, kProbabilityOne}) {
        const std::uint32_t set = model.size_of_set(whole);
        ASSERT_GE(set, 1U);
        ASSERT_LT(set, whole);
        const Interval one = part_for_bit({.start = 7, .size = whole}, set, ~0U);
        const Interval other = part_for_bit({.start = 7, .size = whole}, set, 0);
        EXPECT_EQ(one.start, 7U);
        EXPECT_EQ(one.start + one.size, other.start);
        EXPECT_EQ(other.start + other.size, 7 + whole);
      }
      model.learn(bit ? ~0U : 0);
    }
    EXPECT_EQ(model.size_of_set(1000) > 900, bit);
  }
}

TEST(Compact, CMP7BitsStayPossible) {
  BitModel model;
  for (const bool bit : {true, false}) {
    for (int i = 0; i < 10000; ++i) model.learn(bit);
    EXPECT_GE(model.interval(true).size, 32U);
    EXPECT_GE(model.interval(false).size, 32U);
    EXPECT_LE(model.interval(!bit).size, 40U);
  }
}

TEST(Compact, VectorLoopsEqualPlainOnes) {
  test::RandomBits random(11);
  for (int round = 0; round < 1000; ++round) {
    Lanes lanes{};
    for (auto& lane : lanes) lane = static_cast<std::int16_t>(random() % 32513);
    lanes[0] = 0;
    std::sort(lanes.begin(), lanes.end());
    const auto symbol = static_cast<unsigned>(random() % kSymbols);
    const auto rate = static_cast<unsigned>(2 + random() % 6);
    const CdfTargets targets = make_targets(static_cast<std::int16_t>(32512 + (1 << rate) - 1));
    Lanes pulled = lanes;
    adapt_lanes(pulled.data(), targets[symbol], rate);
    for (unsigned i = 0; i < kSymbols; ++i)
      EXPECT_EQ(pulled[i], lanes[i] + ((targets[symbol][i] - lanes[i]) >> rate));

    const auto weight = static_cast<std::uint16_t>(512 + random() % 31971);
    const std::array<std::uint16_t, 2> weights = {weight, static_cast<std::uint16_t>(32994 - weight)};
    const LaneSum sum(lanes.data(), pulled.data(), weights);
    alignas(16) std::array<std::uint16_t, kSymbols> stored;
    sum.store(stored.data());
    const auto value = static_cast<std::int16_t>(random() % 32768);
    unsigned found = 0;
    for (unsigned i = 0; i < kSymbols; ++i) {
      EXPECT_EQ(stored[i], 2 * i + ((std::uint32_t{weights[0]} * static_cast<std::uint32_t>(lanes[i]) +
                                     std::uint32_t{weights[1]} * static_cast<std::uint32_t>(pulled[i])) >>
                                    15));
      if (stored[i] <= value) found = i;
    }
    EXPECT_EQ(sum.find(value), found);
  }
}

TEST(Compact, CMP15ScaledNumbersOfEverySizeComeBack) {
  std::vector<std::int64_t> numbers = {0, 1, -1, 7, 8, -7, -8, -9, 23, -24, 1000000, -1000000};
  for (const std::int64_t far : {std::int64_t{1} << 30, (std::int64_t{1} << 32) - 1}) {
    numbers.push_back(far);
    numbers.push_back(-far);
  }
  for (unsigned shift = 0; shift <= 24; ++shift) {
    const auto run = [&](auto& coder, bool is_writer) {
      SplitNumberCoder split(coder);
      SymbolModel model = kFreshSplit;
      for (const std::int64_t number : numbers) {
        const Mixture<1> mixture{{&model}};
        EXPECT_EQ(split.code(coder, is_writer ? number : 0, shift, mixture), number) << shift;
      }
    };
    CompactWriter writer;
    run(writer, true);
    const auto bytes = writer.finish();
    CompactReader reader(bytes);
    run(reader, false);
    EXPECT_TRUE(reader.finish(kTag));
  }
}

TEST(Compact, SkewedSymbolsCostNextToNothing) {
  CompactWriter writer;
  SymbolModel model({1, 1, 1, 1, 1, 1, 1, 9, 1, 1, 1, 1, 1, 1, 1, 1});
  for (int i = 0; i < 80000; ++i) writer.symbol(7, Mixture<1>{{&model}});
  EXPECT_LT(writer.finish().size(), 60U);
}

}  // namespace
}  // namespace deltamesh
