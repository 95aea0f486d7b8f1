// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Unit vectors as points of an integer square: the octahedron |x| + |y| + |z| = h unfolded [ATTR-5].
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "base/numbers/vec3.h"

namespace deltamesh {

/// Both coordinates in [0, 2^bits - 2]; 2^bits - 1 twice is the zero vector.
using OctahedralCode = std::array<std::uint32_t, 2>;

/// Half the side of the square, h = 2^(bits-1) - 1. `bits`: 2 to 15.
constexpr std::int32_t octahedral_half(int bits) noexcept { return (std::int32_t{1} << (bits - 1)) - 1; }

constexpr std::uint32_t octahedral_zero(int bits) noexcept { return (std::uint32_t{1} << bits) - 1; }

/// The point of the octahedron that (u, v), each in [-h, h], stands for. The lower half is folded over the
/// edges of the upper:
///
///   -,-  +--------+   the inner diamond |u| + |v| <= h is z >= 0, seen from above;
///        |\ z<0 /\|   each outer corner triangle is the quarter of z < 0 behind the
///        | \   /  |   diamond's side, so that the four corners are all (0, 0, -h).
///        |  z>=0  |
///        +--------+  +,+
constexpr std::array<std::int32_t, 3> octahedral_point(std::int32_t u, std::int32_t v,
                                                       std::int32_t h) noexcept {
  const std::int32_t abs_u = u < 0 ? -u : u;
  const std::int32_t abs_v = v < 0 ? -v : v;
  const std::int32_t z = h - abs_u - abs_v;
  if (z >= 0) return {u, v, z};
  return {u < 0 ? abs_v - h : h - abs_v, v < 0 ? abs_u - h : h - abs_u, z};
}

/// Scaled to unit length. The squares and their sum are exact in a double; square root and division are
/// correctly rounded by IEEE 754, so that every machine gets the same floats.
inline std::array<float, 3> octahedral_direction(const std::array<std::int32_t, 3>& p) noexcept {
  const Vec3 q = widen(p);
  const double size = length(q);
  return {static_cast<float>(q[0] / size), static_cast<float>(q[1] / size), static_cast<float>(q[2] / size)};
}

/// The code whose direction is nearest to `normal` among the four around its exact place. `normal`: finite;
/// near unit length, or zero.
inline OctahedralCode encode_octahedral(const Vec3& normal, int bits) noexcept {
  const double sum = std::fabs(normal[0]) + std::fabs(normal[1]) + std::fabs(normal[2]);
  if (sum == 0) return {octahedral_zero(bits), octahedral_zero(bits)};
  double u = normal[0] / sum;
  double v = normal[1] / sum;
  if (normal[2] < 0) {
    const double folded_u = (1 - std::fabs(v)) * (u < 0 ? -1 : 1);
    v = (1 - std::fabs(u)) * (v < 0 ? -1 : 1);
    u = folded_u;
  }
  const std::int32_t h = octahedral_half(bits);
  const auto cell_u = static_cast<std::int32_t>(std::floor(u * h));
  const auto cell_v = static_cast<std::int32_t>(std::floor(v * h));
  OctahedralCode best{};
  double best_cosine = -2 * length(normal);
  for (std::int32_t i = 0; i < 4; ++i) {
    const std::int32_t a = std::clamp(cell_u + (i & 1), -h, h);
    const std::int32_t b = std::clamp(cell_v + (i >> 1), -h, h);
    const auto p = octahedral_point(a, b, h);
    const Vec3 q = widen(p);
    const double cosine = dot(normal, q) / length(q);
    if (cosine <= best_cosine) continue;
    best_cosine = cosine;
    best = {static_cast<std::uint32_t>(a + h), static_cast<std::uint32_t>(b + h)};
  }
  return best;
}

/// Both coordinates at most 2^bits - 2, or both the zero code; the caller has checked that.
inline std::array<float, 3> decode_octahedral(const OctahedralCode& code, int bits) noexcept {
  if (code[0] == octahedral_zero(bits)) return {0, 0, 0};
  const std::int32_t h = octahedral_half(bits);
  return octahedral_direction(
      octahedral_point(static_cast<std::int32_t>(code[0]) - h, static_cast<std::int32_t>(code[1]) - h, h));
}

}  // namespace deltamesh
