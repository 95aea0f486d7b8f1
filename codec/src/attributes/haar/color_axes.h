// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Colours of 8 bits as luma and two differences, in whole numbers [HAAR-14].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace deltamesh {

inline constexpr std::size_t kHaarAxes = 3;
inline constexpr unsigned kHaarUnitBits = 6;  ///< values are 64ths of a level
using HaarValue = std::array<std::int16_t, kHaarAxes>;
using Rgb = std::array<std::uint8_t, kHaarAxes>;

/// Values stay in a range around the levels, so that sums of a few of them fit 32 bits [HAAR-13].
inline constexpr std::int32_t kLeastHaarValue = -8192;
inline constexpr std::int32_t kMostHaarValue = 24575;

constexpr std::int16_t clamp_haar_value(std::int64_t value) noexcept {
  return static_cast<std::int16_t>(std::clamp<std::int64_t>(value, kLeastHaarValue, kMostHaarValue));
}

/// Y, Cb and Cr of BT.601; one luma alone where `axes` is 1.
inline Rgb rgb_of(const HaarValue& value, unsigned axes) noexcept {
  constexpr unsigned kBits = 14;
  const auto level = [](std::int32_t sum) {
    constexpr unsigned kShift = kBits + kHaarUnitBits;
    return static_cast<std::uint8_t>(std::clamp((sum + (1 << (kShift - 1))) >> kShift, 0, 255));
  };
  const std::int32_t luma = std::int32_t{value[0]} * (1 << kBits);
  if (axes == 1) return {level(luma), level(luma), level(luma)};
  const std::int32_t blue = value[1];
  const std::int32_t red = value[2];
  return {level(luma + 22970 * red), level(luma - 5638 * blue - 11700 * red), level(luma + 29032 * blue)};
}

/// The encoder's side: nearest values.
inline HaarValue haar_value_of(const Rgb& color) noexcept {
  const double red = color[0];
  const double green = color[1];
  const double blue = color[2];
  const double luma = 0.299 * red + 0.587 * green + 0.114 * blue;
  const auto rounded = [](double x) {
    const double scaled = x * (1 << kHaarUnitBits);
    return static_cast<std::int16_t>(scaled < 0 ? scaled - 0.5 : scaled + 0.5);
  };
  return {rounded(luma), rounded((blue - luma) / 1.772), rounded((red - luma) / 1.402)};
}

}  // namespace deltamesh
