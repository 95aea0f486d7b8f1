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
#include <vector>

#include "entropy/compact_model.h"
#include "entropy/lanes.h"

namespace deltamesh {

/// Models alike at first, by number. Lane i of a model is where the interval of symbol i starts.
class QuickModels {
 public:
  /// `weights`: 16 relative frequencies, sum above 0.
  QuickModels(std::size_t count, const std::array<std::uint8_t, kSymbols>& weights)
      : starts_(kSymbols * count + 1), counts_(count) {
    const Lanes fresh = fresh_lanes(weights);
    for (std::size_t model = 0; model < count; ++model) std::copy(fresh.begin(), fresh.end(), lanes(model));
  }

  /// The symbol whose interval holds `slot`, below 2^15.
  [[gnu::always_inline]] unsigned find(std::size_t model, std::uint32_t slot) const noexcept {
    return LaneSum(lanes(model)).find(static_cast<std::int16_t>(slot));
  }

  /// At least 2 and less than 2^15 parts.
  [[gnu::always_inline]] Interval interval(std::size_t model, unsigned symbol) const noexcept {
    // The last symbol's interval ends at 2^15, in place of which the next model has a 0.
    const std::int16_t* const starts = lanes(model) + symbol;
    const std::uint32_t start = static_cast<std::uint16_t>(starts[0]);
    return {start, (static_cast<std::uint16_t>(starts[1]) - start) & (kProbabilityOne - 1)};
  }

  [[gnu::always_inline]] void learn(std::size_t model, unsigned symbol) noexcept {
    const auto [rate, next] = kSteps[counts_[model]];
    counts_[model] = next;
    pull_lanes(lanes(model), kPulls[rate - kFirstRate][symbol], rate);
  }

 private:
  const std::int16_t* lanes(std::size_t model) const noexcept { return starts_.data() + kSymbols * model; }
  std::int16_t* lanes(std::size_t model) noexcept { return starts_.data() + kSymbols * model; }

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

  static Lanes fresh_lanes(const std::array<std::uint8_t, kSymbols>& weights) noexcept {
    std::int32_t sum = 0;
    for (const std::uint8_t weight : weights) sum += weight;
    Lanes lanes{};
    std::int32_t below = 0;
    for (unsigned i = 0; i < kSymbols; ++i) {
      lanes[i] = static_cast<std::int16_t>(static_cast<std::int32_t>(2 * i) + below * kShared / sum);
      below += weights[i];
    }
    return lanes;
  }

  std::vector<std::int16_t> starts_;  ///< kSymbols of every model, and a 0
  std::vector<std::uint8_t> counts_;
};

}  // namespace deltamesh
