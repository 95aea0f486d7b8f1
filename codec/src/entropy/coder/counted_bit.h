// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A model of a bit that learns fast at first: contexts that few symbols have need that [GRD-2].
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "entropy/coder/model.h"

namespace deltamesh {

class CountedBit {
 public:
  constexpr CountedBit() noexcept = default;
  explicit constexpr CountedBit(std::uint16_t first) noexcept : estimate_(first) {}  ///< of 2^16

  Interval interval(bool bit) const noexcept {
    const std::uint32_t one = probability();
    const std::uint32_t if_clear = bit ? 0 : ~0U;  // selects without a branch, which would often go wrong
    return {one & if_clear, (one ^ if_clear) + (if_clear & (kProbabilityOne + 1))};
  }
  /// Of a set bit.
  std::uint32_t probability() const noexcept {
    return std::clamp<std::uint32_t>(estimate_ >> 1, 32, kProbabilityOne - 32);
  }
  void learn(bool bit) noexcept {
    const auto [rate, next] = kSteps[count_];
    count_ = next;
    const std::int32_t goal = -static_cast<std::int32_t>(bit) & 65535;
    estimate_ = static_cast<std::uint16_t>(estimate_ + ((goal - estimate_) >> rate));
  }
  /// As SymbolModel's [CMP-16].
  void limit_count(std::uint8_t most) noexcept { count_ = std::min(count_, most); }

 private:
  static constexpr unsigned kMostCounted = 80;
  struct Step {
    std::uint8_t rate;
    std::uint8_t next;  ///< how many bits will have been seen
  };
  /// By number of bits seen: rate 1 for the first, 2 for the next 2, 3 for the next 4 and so on, 6 up to 80,
  /// then 7.
  static constexpr std::array<Step, kMostCounted + 1> kSteps = [] {
    std::array<Step, kMostCounted + 1> steps{};
    std::uint8_t rate = 1;
    for (unsigned count = 0; count <= kMostCounted; ++count) {
      if (count + 1 == 1U << rate && rate < 6) ++rate;
      steps[count] = {count == kMostCounted ? std::uint8_t{7} : rate,
                      static_cast<std::uint8_t>(std::min(count + 1, kMostCounted))};
    }
    return steps;
  }();

  std::uint16_t estimate_ = 32768;
  std::uint8_t count_ = 0;
};

}  // namespace deltamesh
