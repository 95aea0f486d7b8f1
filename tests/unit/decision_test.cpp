// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Decisions in two contexts: estimates by hand, both directions alike, and what certainty costs.
#include "connectivity/decision.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "entropy/compact_reader.h"
#include "entropy/compact_writer.h"
#include "support/random.h"

namespace deltamesh {
namespace {

TEST(Decision, CMP11EstimatesByHand) {
  Estimate estimate(32768);
  estimate.learn(true);  // half of the way to 65488
  EXPECT_EQ(estimate.probability(), 49128U);
  estimate.learn(false);  // a quarter of the way to 48
  EXPECT_EQ(estimate.probability(), 36858U);
  EXPECT_EQ(estimate.coarse(), 36858U >> 8);
}

TEST(Decision, CMP11EstimatesReachTheirGoalsAndStay) {
  for (const bool yes : {true, false}) {
    Estimate estimate(32768);
    for (int i = 0; i < 5000; ++i) estimate.learn(yes);
    EXPECT_EQ(estimate.probability(), yes ? 65487U : 48U);
    estimate.learn(!yes);
    EXPECT_EQ(estimate.probability(), yes ? 64976U : 559U);
  }
}

/// Answers that mostly follow from their contexts.
struct Answer {
  bool yes;
  DecisionContext context;
};

std::vector<Answer> answers(std::size_t count) {
  test::RandomBits random(5);
  std::vector<Answer> list;
  for (std::size_t i = 0; i < count; ++i) {
    const auto bits = static_cast<std::uint32_t>(random());
    const DecisionContext context{.first = bits % 7, .second = bits / 7 % 3, .set = bits / 32 % 2};
    list.push_back({(context.first + context.second) % 2 == (bits % 1009 < 50 ? 1U : 0U), context});
  }
  return list;
}

TEST(Decision, CMP11ReadsWhatWasWritten) {
  const std::vector<Answer> list = answers(20000);
  CompactWriter writer;
  Decision written(7, 3, 2, 32768);
  for (const Answer& answer : list) EXPECT_EQ(written.code(writer, answer.yes, answer.context), answer.yes);
  const std::vector<std::byte> bytes = writer.finish();
  CompactReader reader(bytes);
  Decision read(7, 3, 2, 32768);
  for (const Answer& answer : list) ASSERT_EQ(read.code(reader, false, answer.context), answer.yes);
  EXPECT_TRUE(reader.finish(0));
  // One in twenty is noise: 0.29 bits each. Without the contexts it would be a bit.
  EXPECT_LT(bytes.size(), list.size() * 45 / 100 / 8);
}

TEST(Decision, CMP11ForegoneAnswersCostAThousandthOfABit) {
  constexpr std::size_t kCount = 1'000'000;
  for (const bool yes : {true, false}) {
    CompactWriter writer;
    Decision decision(1, 1, 1, 32768);
    for (std::size_t i = 0; i < kCount; ++i) decision.code(writer, yes, {.first = 0, .second = 0, .set = 0});
    const std::size_t bytes = writer.finish().size();
    EXPECT_GT(bytes, kCount / 8192);  // what bounds the faces of a byte [CONN-2]
    EXPECT_LT(bytes, kCount / 6000);
  }
}

}  // namespace
}  // namespace deltamesh
