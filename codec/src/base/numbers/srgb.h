// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The curve between what a screen shows and linear light (IEC 61966-2-1), for colours of 0 to 1. Goes on
// above 1, and mirrored below 0.
#pragma once

#include <cmath>

namespace deltamesh {

inline double linear_of_shown(double shown) noexcept {
  const double size = std::fabs(shown);
  const double linear = size <= 0.04045 ? size / 12.92 : std::pow((size + 0.055) / 1.055, 2.4);
  return std::copysign(linear, shown);
}

inline double shown_of_linear(double linear) noexcept {
  const double size = std::fabs(linear);
  const double shown = size <= 0.0031308 ? size * 12.92 : 1.055 * std::pow(size, 1 / 2.4) - 0.055;
  return std::copysign(shown, linear);
}

}  // namespace deltamesh
