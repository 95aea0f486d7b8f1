// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Logarithms, powers and angles that are the same on every machine: those of C libraries differ in their last
// bits, and encoders that decide by them would write different bytes.
#pragma once

#include <cmath>
#include <limits>

#include "base/numbers/vec3.h"

namespace deltamesh {

/// `x` as a float. Through memory: GCC 12 drops the rounding where it vectorises conversions to float and
/// back, as in TwoDoubles{double{float(a)}, double{float(b)}}.
inline float rounded(double x) noexcept {
  volatile float result = static_cast<float>(x);
  return result;
}

/// log2(x) for x >= 0, with an error below 1e-9; -infinity for 0, infinity for infinity.
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

inline constexpr double kPi = 3.14159265358979324;

/// atan(x) for any number, with an error below 1e-14.
inline double portable_atan(double x) noexcept {
  // Each halving of the angle brings tan to x / (1 + sqrt(1 + x^2)); after four it is below 0.05.
  double t = std::fabs(x);
  if (t > 1) return (x < 0 ? -1 : 1) * (kPi / 2 - portable_atan(1 / t));
  for (int i = 0; i < 4; ++i) t = t / (1 + std::sqrt(1 + t * t));
  const double u = t * t;
  const double series = t * (1 - u * (1.0 / 3 - u * (1.0 / 5 - u * (1.0 / 7 - u * (1.0 / 9 - u / 11)))));
  return (x < 0 ? -16 : 16) * series;
}

/// sin(x) for x in radians, -2 pi to 2 pi, with an error below 1e-12.
inline double portable_sin(double x) noexcept {
  const double u = x * x;
  double series = 1;
  for (int i = 30; i > 0; i -= 2) series = 1 - u * series / ((i) * (i + 1));
  return x * series;
}

/// The angle between `a` and `b`, of any length, in degrees, 0 to 180. 0 where both are zero, 90 where one
/// is; not a number where a coordinate is not finite.
inline double portable_degrees_between(const Vec3& a, const Vec3& b) noexcept {
  const double size_a = length(a);
  const double size_b = length(b);
  if (size_a == 0 || size_b == 0) return size_a == size_b ? 0 : 90;
  const Vec3 p = size_b * a;
  const Vec3 q = size_a * b;
  const double far = length(p + q);  // tan(angle / 2) = |p - q| / |p + q|, precise for small angles too
  return far == 0 ? 180 : 360 / kPi * portable_atan(length(p - q) / far);
}

}  // namespace deltamesh
