// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Classes of magnitudes and of their ratios for the contexts of a field, by table [FLD-5]. The tables reach
// as far as what is looked up, so that nothing need be cut.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace deltamesh {

/// Values of a table for all that is below its size.
template <class T, std::size_t kSize, class Value>
constexpr std::array<T, kSize> tabulate(Value value) {
  std::array<T, kSize> table{};
  for (std::uint32_t i = 0; i < kSize; ++i) table[i] = static_cast<T>(value(i));
  return table;
}

/// Four classes per octave of value + 4, from 0 on, 23 at most.
constexpr std::uint32_t octave_class(std::uint32_t value) noexcept {
  const std::uint32_t v = value + 4;
  const auto octave = static_cast<unsigned>(std::bit_width(v)) - 3;
  return std::min(4 * octave + ((v >> octave) & 3), 23U);
}

/// By value: of magnitudes, in the unit that a scale below 64 is given in. None is larger: scales hold 12 /
/// 128 of the axes before, and more of all else.
inline constexpr auto kOctaveClass = tabulate<std::uint8_t, 704>(octave_class);

/// By scale, 64 more where it was shifted.
inline constexpr auto kScaleClass =
    tabulate<std::uint8_t, 128>([](std::uint32_t i) { return octave_class(i % 64) + (i >= 64 ? 4 : 0); });

/// By scale: floor(2^20 / (scale + 2)).
inline constexpr auto kSixteenthsOf =
    tabulate<std::uint32_t, 64>([](std::uint32_t scale) { return (1U << 20) / (scale + 2); });

inline constexpr std::uint32_t kLargestNear = 255;

/// By sixteenths of the scale: how far a mean is from 0, 0 to 5.
inline constexpr auto kSureness =
    tabulate<std::uint8_t, ((kLargestNear * kSixteenthsOf[0]) >> 16) + 1>([](std::uint32_t i) {
      return (i >= 2 ? 1 : 0) + (i >= 5 ? 1 : 0) + (i >= 10 ? 1 : 0) + (i >= 16 ? 1 : 0) + (i >= 27 ? 1 : 0);
    });
inline constexpr std::array<std::uint8_t, 6> kCoarseSureness = {0, 1, 1, 2, 2, 2};

/// By distance of the mean from 0, up to kLargestNear.
inline constexpr auto kNearClass =
    tabulate<std::uint8_t, kLargestNear + 1>([](std::uint32_t near) { return std::min(near / 16, 2U); });

}  // namespace deltamesh
