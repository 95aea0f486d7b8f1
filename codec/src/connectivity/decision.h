// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A yes or no seen in two contexts at once, and how far to trust these together [CONN-15].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "entropy/compact_model.h"

namespace deltamesh {

/// The probability of yes in one context, learnt fast at first.
class Estimate {
 public:
  /// `probability`: parts of 2^16; `seen`: as if learnt from so many.
  explicit constexpr Estimate(std::uint16_t probability, std::uint16_t seen = 0) noexcept
      : probability_(probability), seen_(seen) {}

  std::uint32_t probability() const noexcept { return probability_; }

  /// Moves by 2^-rate of the way, rounded away from where it is.
  void learn(bool yes) noexcept {
    const unsigned rate = kRates[seen_];
    const std::int32_t goal = yes ? 65534 + (1 << rate) : 0;
    probability_ = static_cast<std::uint16_t>(probability_ + ((goal - probability_) >> rate));
    seen_ = static_cast<std::uint16_t>(seen_ + (seen_ + 1U < kRates.size() ? 1 : 0));
  }

 private:
  static constexpr std::array<std::uint8_t, 125> kRates = [] {
    std::array<std::uint8_t, 125> rates{};
    for (unsigned n = 0; n < rates.size(); ++n)
      rates[n] = n < 1 ? 1 : n < 3 ? 2 : n < 12 ? 3 : n < 28 ? 4 : n < 60 ? 5 : n < 124 ? 6 : 7;
    return rates;
  }();

  std::uint16_t probability_;
  std::uint16_t seen_;
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
  Decision(std::size_t first, std::size_t second, std::size_t sets, std::uint16_t probability)
      : first_(first, Estimate(probability)), second_(second, Estimate(probability)) {
    joint_.reserve(sets * kLevels.size() * kLevels.size());
    for (std::size_t set = 0; set < sets; ++set) {
      for (const std::uint32_t a : kLevels) {
        for (const std::uint32_t b : kLevels)
          joint_.push_back(Estimate(static_cast<std::uint16_t>((a + b) / 2), 4));
      }
    }
  }

  /// `Coder` is CompactWriter or CompactReader. Cost O(1).
  template <class Coder>
  [[gnu::always_inline]] bool code(Coder& coder, bool yes, const DecisionContext& context) {
    Estimate& first = first_[context.first];
    Estimate& second = second_[context.second];
    const std::uint32_t a = first.probability();
    const std::uint32_t b = second.probability();
    Estimate& joint = joint_[(context.set * 16 + kLevelOf[a >> 8]) * 16 + kLevelOf[b >> 8]];
    const std::uint32_t probability = (a + b + 6 * joint.probability()) >> 4;
    yes = coder.decide(yes, std::clamp<std::uint32_t>(probability, kLeast, kProbabilityOne - kLeast));
    first.learn(yes);
    second.learn(yes);
    joint.learn(yes);
    return yes;
  }

 private:
  static constexpr std::uint32_t kLeast = 24;
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
