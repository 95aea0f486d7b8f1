// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Adaptive models of 16 symbols that are used one at a time: no mixture, no weights, half the work of those
// of compact_model.h [CMP-13].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "entropy/compact_model.h"
#include "entropy/lanes.h"

namespace deltamesh {

/// Lane i is where the interval of symbol i starts.
class QuickModel {
 public:
  /// `weights`: 16 relative frequencies, sum above 0.
  explicit QuickModel(const std::array<std::uint8_t, kSymbols>& weights) noexcept {
    std::int32_t sum = 0;
    for (const std::uint8_t weight : weights) sum += weight;
    std::int32_t below = 0;
    for (unsigned i = 0; i < kSymbols; ++i) {
      starts_[i] = static_cast<std::int16_t>(static_cast<std::int32_t>(2 * i) + below * kShared / sum);
      below += weights[i];
    }
    starts_[kSymbols] = std::numeric_limits<std::int16_t>::min();
  }

  /// The symbol whose interval holds `slot`, below 2^15.
  [[gnu::always_inline]] unsigned find(std::uint32_t slot) const noexcept {
    return LaneSum(starts_.data()).find(static_cast<std::int16_t>(slot));
  }

  /// At least 2 and less than 2^15 parts.
  [[gnu::always_inline]] Interval interval(unsigned symbol) const noexcept {
    const std::uint32_t start = static_cast<std::uint16_t>(starts_[symbol]);
    return {start, static_cast<std::uint16_t>(starts_[symbol + 1]) - start};
  }

  [[gnu::always_inline]] void learn(unsigned symbol) noexcept {
    const auto [rate, next] = kSteps[count_];
    count_ = next;
    pull_lanes(starts_.data(), kPulls[rate - kFirstRate][symbol], rate);
  }

 private:
  static constexpr unsigned kFirstRate = 3;
  static constexpr unsigned kLastRate = 8;
  static constexpr unsigned kMostCounted = 250;
  /// What symbols share by weight; the last has as much more as rounding needs.
  static constexpr std::int32_t kShared = kProbabilityOne - (1 << kLastRate) - 2 * (kSymbols - 1);

  struct Step {
    std::uint8_t rate;
    std::uint8_t next;  ///< how many symbols will have been seen
  };
  static constexpr std::array<Step, kMostCounted + 1> kSteps = [] {
    std::array<Step, kMostCounted + 1> steps{};
    std::uint8_t rate = kFirstRate;
    for (unsigned count = 0; count <= kMostCounted; ++count) {
      if (count + 6 == 2U << rate) ++rate;
      steps[count] = {rate, static_cast<std::uint8_t>(std::min(count + 1, kMostCounted))};
    }
    return steps;
  }();

  static constexpr std::array<Pulls, kLastRate - kFirstRate + 1> kPulls = [] {
    std::array<Pulls, kLastRate - kFirstRate + 1> pulls{};
    for (unsigned rate = kFirstRate; rate <= kLastRate; ++rate) {
      for (unsigned symbol = 0; symbol < kSymbols; ++symbol) {
        for (unsigned i = 0; i < kSymbols; ++i) {
          const std::int32_t above = kShared + (1 << rate) - 1;
          pulls[rate - kFirstRate][symbol][i] =
              static_cast<std::int16_t>(static_cast<std::int32_t>(2 * i) + (i > symbol ? above : 0));
        }
      }
    }
    return pulls;
  }();

  alignas(16) std::array<std::int16_t, kSymbols + 1> starts_{};  ///< and where the last one ends, modulo 2^16
  std::uint8_t count_ = 0;                                       ///< symbols seen, to kMostCounted
};

}  // namespace deltamesh
