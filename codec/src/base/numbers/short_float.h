// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Short floats: f32 whose lowest byte is 0, so that three bytes hold them [CON-6].
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace deltamesh {

inline constexpr std::uint32_t kShortFloatMask = 0xffffff00;

/// `value` without what a short float has no room for.
inline float cut_to_short(float value) noexcept {
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) & kShortFloatMask);
}

/// The smallest short float that is not below `value`, which is 0 or more; infinity where there is none.
inline float short_float_above(double value) noexcept {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  if (!(value <= static_cast<double>(std::numeric_limits<float>::max()))) return kInfinity;
  const auto rounded = static_cast<float>(value);
  const float above = static_cast<double>(rounded) >= value ? rounded : std::nextafter(rounded, kInfinity);
  const auto bits = std::bit_cast<std::uint32_t>(above);
  return std::bit_cast<float>((bits + ~kShortFloatMask) & kShortFloatMask);
}

/// The largest finite short float that is not above `value`, which is above 0; `value` itself where that
/// would be 0.
inline double short_float_below(double value) noexcept {
  constexpr double kMost = std::numeric_limits<float>::max();
  const auto rounded = static_cast<float>(std::min(value, kMost));
  const float below = static_cast<double>(rounded) <= value ? rounded : std::nextafter(rounded, 0.0F);
  const float cut = cut_to_short(below);
  return cut > 0 ? cut : value;
}

/// Whether three bytes hold `value`.
inline bool is_short_float(double value) noexcept {
  const double most = std::numeric_limits<float>::max();
  if (!(value >= -most && value <= most)) return false;
  return static_cast<double>(cut_to_short(static_cast<float>(value))) == value;
}

}  // namespace deltamesh
