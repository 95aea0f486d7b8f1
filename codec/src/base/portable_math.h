// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Logarithms and powers that are the same on every machine: those of C libraries differ in their last bits,
// and encoders that decide by them would write different bytes.
#pragma once

#include <cmath>
#include <limits>

namespace deltamesh {

/// Of `x`, 0 or above; within 1e-9 of the true one. -infinity of 0, infinity of infinity.
inline double portable_log2(double x) noexcept {
  if (!(x > 0))
    return x == 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN();
  if (std::isinf(x)) return x;
  constexpr double kSqrtHalf = 0.70710678118654752;
  constexpr double kTwoOverLn2 = 2.8853900817779268;
  int exponent = 0;
  double m = std::frexp(x, &exponent);  // 0.5 to 1
  if (m < kSqrtHalf) {
    m *= 2;
    --exponent;
  }
  // ln m = 2 artanh t, whose series ends soon where |t| < 0.18.
  const double t = (m - 1) / (m + 1);
  const double u = t * t;
  const double series = 1 + u * (1.0 / 3 + u * (1.0 / 5 + u * (1.0 / 7 + u * (1.0 / 9 + u * (1.0 / 11)))));
  return exponent + kTwoOverLn2 * t * series;
}

/// 2^x, within 1e-13 of itself; 0 or infinity beyond the range of doubles.
inline double portable_exp2(double x) noexcept {
  if (std::isnan(x)) return x;
  if (x > 1100) return std::numeric_limits<double>::infinity();
  if (x < -1200) return 0;
  constexpr double kLn2 = 0.69314718055994531;
  const double whole = std::floor(x + 0.5);
  const double y = kLn2 * (x - whole);
  double power = 1;
  for (int i = 12; i > 0; --i) power = 1 + y * power / i;
  return std::ldexp(power, static_cast<int>(whole));
}

}  // namespace deltamesh
