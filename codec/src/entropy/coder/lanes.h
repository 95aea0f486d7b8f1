// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Sixteen 16-bit numbers handled at once: the inner loops of the compact coder.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "base/simd/eight_shorts.h"

namespace deltamesh {

inline constexpr unsigned kSymbols = 16;

struct alignas(16) Lanes : std::array<std::int16_t, kSymbols> {};

/// Targets of the adaptation to symbol s: 0 for lanes 0 to s, `goal` for the others.
using CdfTargets = std::array<Lanes, kSymbols>;
constexpr CdfTargets make_targets(std::int16_t goal) noexcept {
  CdfTargets targets{};
  for (unsigned s = 0; s < kSymbols; ++s)
    for (unsigned i = s + 1; i < kSymbols; ++i) targets[s][i] = goal;
  return targets;
}

/// Lanes are aligned to 16 bytes; eight of them, from 8 * half on.
inline EightShorts load_lanes(const std::int16_t* lanes, std::size_t half) noexcept {
  EightShorts loaded;
  std::memcpy(&loaded, __builtin_assume_aligned(lanes + 8 * half, sizeof(loaded)), sizeof(loaded));
  return loaded;
}
inline void store_lanes(void* lanes, std::size_t half, EightShorts values) noexcept {
  std::memcpy(__builtin_assume_aligned(static_cast<std::int16_t*>(lanes) + 8 * half, sizeof(values)), &values,
              sizeof(values));
}

/// lane += (target - lane) >> rate
inline void adapt_lanes(std::int16_t* lanes, const Lanes& target, unsigned rate) noexcept {
  for (std::size_t half = 0; half < 2; ++half) {
    const EightShorts now = load_lanes(lanes, half);
    const EightShorts way = load_lanes(target.data(), half) - now;
    store_lanes(lanes, half, now + (way >> static_cast<std::int16_t>(rate)));
  }
}

/// The start of each symbol's interval in a mixture of two models.
class LaneSum {
 public:
  /// Lane i: 2 i + (a[i] * weights[0] + b[i] * weights[1]) / 2^15, rounded down. 16 lanes each, not negative;
  /// the weights below 2^15.
  [[gnu::always_inline]] LaneSum(const std::int16_t* a, const std::int16_t* b,
                                 const std::array<std::uint16_t, 2>& weights) noexcept {
    const auto both = std::bit_cast<std::int32_t>(weights);
    const auto pairs = reinterpret_cast<EightShorts>(FourInts{both, both, both, both});
    low_ = mix(a, b, pairs, 0);
    high_ = mix(a, b, pairs, 1);
  }

  /// The last lane that is at most `value`; the lanes rise, the first is 0.
  [[gnu::always_inline]] unsigned find(std::int16_t value) const noexcept {
    const EightShorts values = all_lanes(value);
    // One bit per lane that is larger; the one before the first of them is the last that is not.
    const unsigned larger = set_lanes(low_ > values, high_ > values) | 1U << kSymbols;
    return static_cast<unsigned>(std::countr_zero(larger)) - 1;
  }

  /// Into 16 numbers, aligned to 16 bytes.
  [[gnu::always_inline]] void store(std::uint16_t* lanes) const noexcept {
    store_lanes(lanes, 0, low_);
    store_lanes(lanes, 1, high_);
  }

 private:
  static constexpr Lanes kLeast = {0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30};

  [[gnu::always_inline]] static EightShorts mix(const std::int16_t* a, const std::int16_t* b,
                                                EightShorts weights, std::size_t half) noexcept {
    const EightShorts of_a = load_lanes(a, half);
    const EightShorts of_b = load_lanes(b, half);
    return load_lanes(kLeast.data(), half) + pack_lanes(weighted_sums(of_a, of_b, weights) >> 15,
                                                        weighted_high_sums(of_a, of_b, weights) >> 15);
  }

  EightShorts low_;
  EightShorts high_;
};

}  // namespace deltamesh
