// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A yes or no seen in two contexts at once, and how far to trust these together [CMP-11].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace deltamesh {

/// The probability of yes in one context, learnt fast at first.
class Estimate {
 public:
  /// `probability`: parts of 2^16; `seen`: as if learnt from so many.
  explicit constexpr Estimate(std::uint32_t probability, std::uint32_t seen = 0) noexcept
      : state_(probability << (kSeenBits + 8) | seen) {}

  /// Parts of 2^16.
  std::uint32_t probability() const noexcept { return state_ >> (kSeenBits + 8); }
  /// The highest 8 bits of it.
  std::uint32_t coarse() const noexcept { return state_ >> (kSeenBits + 16); }

  /// Moves by 2^-rate of the way to the answer's goal.
  void learn(bool yes) noexcept {
    const unsigned pace = kPaces[state_ % (1U << kSeenBits)];
    const std::int32_t way = (yes ? kYes : kNo) - static_cast<std::int32_t>(state_ >> kSeenBits);
    state_ += (static_cast<std::uint32_t>(way >> (pace % 32)) << kSeenBits) + pace / 32;
  }

 private:
  static constexpr unsigned kSeenBits = 7;
  /// Goals short of certainty, so that no mean of estimates comes nearer to it than 24 parts of 2^15.
  static constexpr std::int32_t kNo = 48 << 8;
  static constexpr std::int32_t kYes = (65536 - 48) << 8;
  static constexpr unsigned kMostSeen = 124;
  /// By how often it learnt: the rate, plus 32 as long as it counts on.
  static constexpr std::array<std::uint8_t, 1 << kSeenBits> kPaces = [] {
    std::array<std::uint8_t, 1 << kSeenBits> paces{};
    for (unsigned n = 0; n <= kMostSeen; ++n) {
      const unsigned rate = n < 1           ? 1
                            : n < 3         ? 2
                            : n < 12        ? 3
                            : n < 28        ? 4
                            : n < 60        ? 5
                            : n < kMostSeen ? 6
                                            : 7;
      paces[n] = static_cast<std::uint8_t>(rate + (n < kMostSeen ? 32 : 0));
    }
    return paces;
  }();

  std::uint32_t state_;  ///< parts of 2^24, and in the lowest bits how often it learnt, up to 124
};

/// Where a decision stands: an index into either table of estimates, and into the sets of the table that
/// joins them.
struct DecisionContext {
  std::uint32_t first;
  std::uint32_t second;
  std::uint32_t set;
};

/// The two estimates choose one of 16 x 16 further estimates, which learns what came of such pairs; the
/// answer leans on it by three quarters, and by a quarter on the two themselves.
class Decision {
 public:
  /// Sizes of the tables; `probability`: what estimates start from, parts of 2^16.
  Decision(std::size_t first, std::size_t second, std::size_t sets, std::uint32_t probability)
      : first_(first, Estimate(probability)), second_(second, Estimate(probability)) {
    joint_.reserve(sets * kLevels.size() * kLevels.size());
    for (std::size_t set = 0; set < sets; ++set) {
      for (const std::uint32_t a : kLevels) {
        for (const std::uint32_t b : kLevels) joint_.push_back(Estimate((a + b) / 2, 4));
      }
    }
  }

  /// `Coder` is CompactWriter or CompactReader. Cost O(1).
  template <class Coder>
  [[gnu::always_inline]] bool code(Coder& coder, bool yes, const DecisionContext& context) {
    Estimate& first = first_[context.first];
    Estimate& second = second_[context.second];
    Estimate& joint = joint_[(context.set * kLevels.size() + kLevelOf[first.coarse()]) * kLevels.size() +
                             kLevelOf[second.coarse()]];
    const auto learn = [&](bool answer) {
      first.learn(answer);
      second.learn(answer);
      joint.learn(answer);
      return answer;
    };
    const std::uint32_t probability =
        (first.probability() + second.probability() + 6 * joint.probability()) >> 4;
    return coder.decide(yes, probability) ? learn(true) : learn(false);
  }

 private:
  /// Even steps of the logarithm of the odds.
  static constexpr std::array<std::uint16_t, 16> kLevels = {
      162, 360, 795, 1743, 3757, 7812, 15170, 26300, 39235, 50365, 57723, 61778, 63792, 64740, 65175, 65373};
  static constexpr std::array<std::uint8_t, 15> kSteps = {1,   2,   5,   10,  21,  43,  79, 128,
                                                          177, 213, 235, 246, 251, 254, 255};
  /// Level of an estimate's upper 8 bits.
  static constexpr std::array<std::uint8_t, 256> kLevelOf = [] {
    std::array<std::uint8_t, 256> levels{};
    for (unsigned p = 0; p < 256; ++p) {
      for (const std::uint8_t step : kSteps)
        levels[p] = static_cast<std::uint8_t>(levels[p] + (p >= step ? 1 : 0));
    }
    return levels;
  }();

  std::vector<Estimate> first_;
  std::vector<Estimate> second_;
  std::vector<Estimate> joint_;
};

}  // namespace deltamesh
