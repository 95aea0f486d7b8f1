// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/memory/large_vector.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace deltamesh {
namespace {

/// On both sides of where large pages begin, and of where one more of them is taken.
constexpr std::array<std::size_t, 9> kSizes = {
    0, 1, 1000, (1U << 20) - 1, 1U << 20, (1U << 20) + 1, 3U << 20, (3U << 20) - 1, 5000001};

TEST(LargeVector, KeepsEveryByteOfAnySize) {
  for (const std::size_t size : kSizes) {
    LargeVector<std::uint8_t> bytes(size);
    std::iota(bytes.begin(), bytes.end(), std::uint8_t{3});
    const LargeVector<std::uint8_t> copy = bytes;
    LargeVector<std::uint8_t> moved = std::move(bytes);
    EXPECT_EQ(copy, moved);
    moved.push_back(77);
    ASSERT_EQ(moved.size(), size + 1);
    EXPECT_EQ(moved.back(), 77);
    moved.pop_back();
    EXPECT_EQ(copy, moved);
  }
}

TEST(LargeVector, ClearsOnRequest) {
  for (const std::size_t size : kSizes) {
    { LargeVector<std::uint8_t> before(size, 255); }
    const LargeVector<std::uint8_t> zeros(size, 0);
    EXPECT_EQ(std::accumulate(zeros.begin(), zeros.end(), std::size_t{0}), 0U);
    LargeVector<std::uint8_t> assigned;
    assigned.assign(size, 0);
    EXPECT_EQ(assigned, zeros);
  }
}

TEST(LargeVector, BeginsElementsThatAreNoNumbers) {
  const LargeVector<std::string> words(100000);
  for (const std::string& word : words) ASSERT_EQ(word, "");
}

TEST(LargeVector, RefusesWhatNoMachineHas) {
  LargeVector<std::uint64_t> values;
  EXPECT_THROW(values.reserve(std::size_t{1} << 60), std::length_error);
}

TEST(LargeVector, ReservesForOthers) {
  for (const std::size_t size : kSizes) {
    std::vector<std::uint32_t> values;
    reserve_large(values, size);
    EXPECT_GE(values.capacity(), size);
    values.resize(size);
    EXPECT_EQ(std::accumulate(values.begin(), values.end(), std::uint32_t{0}), 0U);
  }
}

}  // namespace
}  // namespace deltamesh
