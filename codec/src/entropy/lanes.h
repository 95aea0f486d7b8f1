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

#include "base/eight_shorts.h"

namespace deltamesh {

inline constexpr unsigned kSymbols = 16;

struct alignas(16) Lanes : std::array<std::int16_t, kSymbols> {};

/// Where lanes are pulled to: those up to s to 0, the others to `goal`.
using Pulls = std::array<Lanes, kSymbols>;
constexpr Pulls make_pulls(std::int16_t goal) noexcept {
  Pulls pulls{};
  for (unsigned s = 0; s < kSymbols; ++s)
    for (unsigned i = s + 1; i < kSymbols; ++i) pulls[s][i] = goal;
  return pulls;
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

/// lane += (pull - lane) >> rate
inline void pull_lanes(std::int16_t* lanes, const Lanes& pull, unsigned rate) noexcept {
  for (std::size_t half = 0; half < 2; ++half) {
    const EightShorts now = load_lanes(lanes, half);
    const EightShorts way = load_lanes(pull.data(), half) - now;
    store_lanes(lanes, half, now + (way >> static_cast<std::int16_t>(rate)));
  }
}

/// Lanes that are summed up and searched.
class LaneSum {
 public:
  explicit LaneSum(const Lanes& lanes) noexcept : LaneSum(lanes.data()) {}
  /// `lanes`: as many as there are symbols.
  explicit LaneSum(const std::int16_t* lanes) noexcept
      : low_(load_lanes(lanes, 0)), high_(load_lanes(lanes, 1)) {}

  /// Adds 2 * lanes * weights[k] / 2^16 for all k, rounded down each; lanes not negative, 16 each, the
  /// weights below 2^15, but for that of one alone.
  template <std::size_t K>
  [[gnu::always_inline]] void add_weighted(const std::array<const std::int16_t*, K>& lanes,
                                           const std::array<std::uint16_t, 4>& weights) noexcept {
    // Twice the weights, as a lane's double may be too large; twice that of one alone is too, by 2^16.
    using TwoLongs = std::int64_t __attribute__((vector_size(16)));
    const auto four = reinterpret_cast<EightShorts>(TwoLongs{std::bit_cast<std::int64_t>(weights), 0});
    const EightShorts pairs = pick_lanes<0, 0, 1, 1, 2, 2, 3, 3>(four);
    const EightShorts twice = wrapped_sum(pairs, pairs);
    if constexpr (K == 1) {
      low_ += load_lanes(lanes[0], 0);
      high_ += load_lanes(lanes[0], 1);
    }
    add_one<0>(lanes[0], twice);
    if constexpr (K > 1) add_one<1>(lanes[1], twice);
    if constexpr (K > 2) add_one<2>(lanes[2], twice);
    if constexpr (K > 3) add_one<3>(lanes[3], twice);
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
  template <int kPlace>
  [[gnu::always_inline]] void add_one(const std::int16_t* lanes, EightShorts twice) noexcept {
    constexpr int k = 2 * kPlace;
    const EightShorts weight = pick_lanes<k, k + 1, k, k + 1, k, k + 1, k, k + 1>(twice);
    low_ += multiply_high_unsigned(load_lanes(lanes, 0), weight);
    high_ += multiply_high_unsigned(load_lanes(lanes, 1), weight);
  }

  EightShorts low_;
  EightShorts high_;
};

}  // namespace deltamesh
