// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Classes of magnitudes and of their ratios for the contexts of a field, by table [FLD-5].
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace deltamesh {

/// Four classes per octave of value + 4, from 0 on, 23 at most.
inline constexpr std::array<std::uint8_t, 256> kOctaveClass = [] {
  std::array<std::uint8_t, 256> classes{};
  for (unsigned value = 0; value < classes.size(); ++value) {
    const unsigned v = value + 4;
    const auto octave = static_cast<unsigned>(std::bit_width(v)) - 3;
    classes[value] = static_cast<std::uint8_t>(std::min(4 * octave + ((v >> octave) & 3), 23U));
  }
  return classes;
}();

/// floor(2^20 / (scale + 2))
inline constexpr std::array<std::uint32_t, 64> kSixteenthsOf = [] {
  std::array<std::uint32_t, 64> table{};
  for (std::uint32_t scale = 0; scale < table.size(); ++scale) table[scale] = (1U << 20) / (scale + 2);
  return table;
}();

/// By sixteenths.
inline constexpr std::array<std::uint8_t, 32> kSurenessClass = [] {
  std::array<std::uint8_t, 32> classes{};
  for (unsigned i = 0; i < classes.size(); ++i)
    classes[i] = static_cast<std::uint8_t>((i >= 2 ? 1 : 0) + (i >= 5 ? 1 : 0) + (i >= 10 ? 1 : 0) +
                                           (i >= 16 ? 1 : 0) + (i >= 27 ? 1 : 0));
  return classes;
}();
inline constexpr std::array<std::uint8_t, 6> kCoarseSureness = {0, 1, 1, 2, 2, 2};

/// How far a mean is from 0 in terms of the scale: 0 to 5. `near`: at most 255; `scale`: at most 63.
constexpr std::uint32_t sureness(std::uint32_t near, std::uint32_t scale) noexcept {
  return kSurenessClass[std::min((near * kSixteenthsOf[scale]) >> 16, 31U)];
}

}  // namespace deltamesh
