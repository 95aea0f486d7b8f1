// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Rounding of moderate numbers without calls of a library, which plain x86-64 takes for std::round and
// std::floor. Encoder only.
#pragma once

#include <cmath>
#include <cstdint>

namespace deltamesh {

/// The nearest whole number, of two the one farther from 0; but 1 for 0.49999999999999994, as adding a half
/// rounds. |x| below 2^51.
inline double nearest(double x) noexcept {
  return static_cast<double>(static_cast<std::int64_t>(x + std::copysign(0.5, x)));
}

/// The largest whole number that is not above `x`. |x| below 2^63.
inline double floor_of(double x) noexcept {
  const auto cut = static_cast<double>(static_cast<std::int64_t>(x));
  return cut > x ? cut - 1 : cut;
}

}  // namespace deltamesh
