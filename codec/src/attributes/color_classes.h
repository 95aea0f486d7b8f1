// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Classes of scales, and of what is expected beside them, for the contexts of colours, by table [ATTR-52].
#pragma once

#include <cstdint>

#include "field/octave_class.h"

namespace deltamesh {

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

}  // namespace deltamesh
