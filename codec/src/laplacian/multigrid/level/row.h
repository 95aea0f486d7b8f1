// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Four floats that are worked on at once: x, y, z and a pad, which is 0 or a probe of settling.
#pragma once

#include "base/numbers/vec3.h"
#include "base/simd/four_floats.h"
#include "base/simd/two_doubles.h"

namespace deltamesh::multigrid {

using Float4 = FourFloats;

/// The same in doubles, as two halves that every instruction set has registers for.
struct Double4 {
  TwoDoubles xy{};
  TwoDoubles zw{};

  Double4& operator+=(const Double4& other) noexcept {
    xy += other.xy;
    zw += other.zw;
    return *this;
  }
  Double4& operator-=(const Double4& other) noexcept {
    xy -= other.xy;
    zw -= other.zw;
    return *this;
  }
  friend Double4 operator+(Double4 a, const Double4& b) noexcept { return a += b; }
  friend Double4 operator-(Double4 a, const Double4& b) noexcept { return a -= b; }
  friend Double4 operator*(const Double4& a, const Double4& b) noexcept { return {a.xy * b.xy, a.zw * b.zw}; }
  friend Double4 operator*(double factor, const Double4& a) noexcept {
    return {factor * a.xy, factor * a.zw};
  }
};

/// a / b by lane; 0 in lanes where b is not above 0.
inline Double4 ratio(const Double4& a, const Double4& b) noexcept {
  const auto divide = [](double p, double q) { return q > 0 ? p / q : 0.0; };
  return {TwoDoubles{divide(a.xy[0], b.xy[0]), divide(a.xy[1], b.xy[1])},
          TwoDoubles{divide(a.zw[0], b.zw[0]), divide(a.zw[1], b.zw[1])}};
}

inline Double4 widen(Float4 v) noexcept { return Double4{TwoDoubles{v[0], v[1]}, TwoDoubles{v[2], v[3]}}; }
inline Float4 narrow(const Double4& v) noexcept { return narrow_lanes(v.xy, v.zw); }

inline Float4 to_float4(const Vec3& v) noexcept {
  return Float4{static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]), 0.0F};
}

/// Both fields of a vertex side by side: one 32-byte load per neighbour serves both and all axes.
struct alignas(32) Row {
  Float4 x;  ///< position, or its equation's right-hand side
  Float4 s;  ///< residual field D^-1 (delta - L x), or its equation's right-hand side

  Row& operator+=(const Row& other) noexcept {
    x += other.x;
    s += other.s;
    return *this;
  }
  friend Row operator+(const Row& a, const Row& b) noexcept { return {a.x + b.x, a.s + b.s}; }
  friend Row operator*(float factor, const Row& a) noexcept { return {factor * a.x, factor * a.s}; }
};

}  // namespace deltamesh::multigrid
