// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Uniform levels over a range: integers to fewer levels [ATTR-6], floats over [min, max] [ATTR-6, ATTR-7].
#pragma once

#include <cmath>
#include <cstdint>

namespace deltamesh {

/// Highest level of `bits` bits, 1 to 31.
constexpr std::uint32_t top_level(int bits) noexcept { return (std::uint32_t{1} << bits) - 1; }

/// `value` in [0, from] to [0, to], rounded to nearest, halves up. Exact in 64 bits: both tops are below
/// 2^31.
constexpr std::uint32_t rescale_level(std::uint32_t value, std::uint32_t from, std::uint32_t to) noexcept {
  return static_cast<std::uint32_t>((2 * std::uint64_t{value} * to + from) / (2 * std::uint64_t{from}));
}

/// The range of one axis; finite, min <= max.
struct LevelRange {
  float min = 0;
  float max = 1;
};

/// `value` in [min, max] to [0, top], rounded to nearest.
inline std::uint32_t level_of(float value, const LevelRange& range, std::uint32_t top) noexcept {
  const double extent = static_cast<double>(range.max) - static_cast<double>(range.min);
  if (extent == 0) return 0;
  const double share = (static_cast<double>(value) - static_cast<double>(range.min)) / extent;
  return static_cast<std::uint32_t>(std::floor(share * top + 0.5));
}

/// The value of a level, in this order of operations in double, then rounded to float. Always finite.
inline float value_of(std::uint32_t level, const LevelRange& range, std::uint32_t top) noexcept {
  const double extent = static_cast<double>(range.max) - static_cast<double>(range.min);
  return static_cast<float>(static_cast<double>(range.min) + extent * level / top);
}

}  // namespace deltamesh
