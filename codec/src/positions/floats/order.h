// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Floats as whole numbers: in their order, for exact residuals, and as multiples of a unit, for prediction
// [FLT-1 .. FLT-3]. Integers only.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "base/numbers/vec3.h"

namespace deltamesh {

inline constexpr std::int32_t kLargestFixed = 1 << 27;       ///< in units, either sign
inline constexpr std::int32_t kLargestOrdinal = 0x7f7fffff;  ///< of the largest finite float

/// 0 for +0, ascending with the value; -1 for -0 [FLT-1].
constexpr std::int32_t ordinal_of(float x) noexcept {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const auto size = static_cast<std::int32_t>(bits & 0x7fffffffU);
  return bits >> 31 != 0 ? -1 - size : size;
}

/// Precondition: is_finite_ordinal().
constexpr float float_of(std::int32_t ordinal) noexcept {
  if (ordinal >= 0) return std::bit_cast<float>(static_cast<std::uint32_t>(ordinal));
  return std::bit_cast<float>(static_cast<std::uint32_t>(-1 - ordinal) | 0x80000000U);
}

constexpr bool is_finite_ordinal(std::int64_t ordinal) noexcept {
  return ordinal <= kLargestOrdinal && ordinal >= -1 - std::int64_t{kLargestOrdinal};
}

/// The exponent of the last place of a float's magnitude bits: its value is mantissa * 2^exponent.
constexpr int last_place(std::uint32_t size) noexcept {
  return std::max<int>(static_cast<int>(size >> 23), 1) - 150;
}

/// A unit of 2^exponent: the largest coordinate of an axis takes 27 bits of it [FLT-2].
constexpr int unit_exponent(float low, float high) noexcept {
  const std::uint32_t size = std::max(std::bit_cast<std::uint32_t>(low) & 0x7fffffffU,
                                      std::bit_cast<std::uint32_t>(high) & 0x7fffffffU);
  return last_place(size) - 3;
}

inline std::array<int, 3> float_units(const Box& box) noexcept {
  std::array<int, 3> units{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    units[axis] = unit_exponent(static_cast<float>(box.min[axis]), static_cast<float>(box.max[axis]));
  return units;
}

/// The float in units, cut towards 0, at most kLargestFixed in size [FLT-2].
constexpr std::int32_t fixed_of(std::int32_t ordinal, int unit) noexcept {
  const auto size = static_cast<std::uint32_t>(ordinal >= 0 ? ordinal : -1 - ordinal);
  const std::uint64_t mantissa = (size & 0x7fffffU) | (size >> 23 != 0 ? 0x800000U : 0U);
  const int shift = last_place(size) - unit;
  const std::uint64_t units = shift >= 0 ? mantissa << std::min(shift, 30) : mantissa >> std::min(-shift, 30);
  const auto fixed = static_cast<std::int32_t>(std::min<std::uint64_t>(units, kLargestFixed));
  return ordinal >= 0 ? fixed : -fixed;
}

/// The ordinal of so many units, cut towards 0 where a float has no room [FLT-3]. `fixed`: at most 2^29 in
/// size; `unit`: of unit_exponent().
constexpr std::int32_t ordinal_of_fixed(std::int32_t fixed, int unit) noexcept {
  const auto units = static_cast<std::uint64_t>(fixed >= 0 ? fixed : -fixed);
  if (units == 0) return 0;
  const int width = static_cast<int>(std::bit_width(units));
  // The exponent of the last place: 24 bits of mantissa, but none below the smallest float's.
  const int place = std::max(width - 24 + unit, -149);
  const int shift = unit - place;
  const std::uint64_t mantissa = shift >= 0 ? units << std::min(shift, 30) : units >> std::min(-shift, 60);
  // A mantissa without its leading bit, 2^23, is a subnormal one's, whose exponent field is 0.
  const auto size = static_cast<std::int64_t>(mantissa) + (static_cast<std::int64_t>(place + 149) << 23);
  const auto capped = static_cast<std::int32_t>(std::min<std::int64_t>(size, kLargestOrdinal));
  return fixed >= 0 ? capped : -1 - capped;
}

}  // namespace deltamesh
