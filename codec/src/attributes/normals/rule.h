// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Normals by rule: the weighted sum of the unit normals of the faces around a vertex [ATTR-22]. Floats, + - *
// / sqrt only.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/memory/large_vector.h"
#include "base/simd/four_floats.h"

namespace deltamesh {

/// The weight of a face in the normal of a vertex.
enum class NormalRule : std::uint8_t {
  kNone = 0,       ///< normals are not predicted from faces
  kPlain = 1,      ///< 1
  kArea = 2,       ///< its area
  kAngle = 3,      ///< its angle at the vertex
  kAreaAngle = 4,  ///< area times angle
  kEdges = 5,      ///< area over the squared lengths of both edges at the vertex (Max 1999)
};

/// Weighted sum over the faces at a vertex: three components of the normal, then the sum of the weights.
using RuleSum = FourFloats;

/// Three coordinates of four vectors.
using FourVectors = std::array<FourFloats, 3>;

inline FourVectors operator-(const FourVectors& a, const FourVectors& b) noexcept {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline FourFloats dot(const FourVectors& a, const FourVectors& b) noexcept {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The angles of four vectors with components `x` and `y` (0 or above, not both 0), 0 to pi, within 2e-5.
inline FourFloats corner_angles(FourFloats x, FourFloats y) noexcept {
  constexpr float kHalfPi = 1.57079633F;
  const FourFloats size = x < 0 ? -x : x;
  const FourFloats t = y > size ? size / y : y / size;  // 0 to 1
  // Abramowitz and Stegun 4.4.47.
  const FourFloats s = t * t;
  const FourFloats arc =
      t * (0.9998660F + s * (-0.3302995F + s * (0.1801410F + s * (-0.0851330F + s * 0.0208351F))));
  const FourFloats acute = y > size ? kHalfPi - arc : arc;
  return x < 0 ? 2 * kHalfPi - acute : acute;
}

/// Four faces, and what they add at their corners.
class FourFaces {
 public:
  /// `faces`: the vertices of each; `positions`: n x 3, multiplied by `scale` first.
  FourFaces(NormalRule rule, const std::array<const std::uint32_t*, 4>& faces, const float* positions,
            float scale) noexcept {
    const auto corner = [&](std::size_t k) {
      FourVectors p;
      for (std::size_t c = 0; c < 3; ++c) {
        const auto at = [&](std::size_t face) { return positions[3 * std::size_t{faces[face][k]} + c]; };
        p[c] = FourFloats{at(0), at(1), at(2), at(3)} * scale;
      }
      return p;
    };
    const FourVectors origin = corner(0);
    const FourVectors a = corner(1) - origin;
    const FourVectors b = corner(2) - origin;
    const FourVectors n = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const FourFloats square = dot(n, n);
    const auto is_face = square > 1e-36F;
    const FourFloats none{};
    const FourFloats size = square_roots(is_face ? square : none + 1);
    const FourFloats inverse = 1 / size;
    unit_ = {n[0] * inverse, n[1] * inverse, n[2] * inverse};
    const FourVectors c = b - a;
    std::array<FourFloats, 3> weights{none + 1, none + 1, none + 1};
    if (rule == NormalRule::kArea) weights = {size, size, size};
    if (rule == NormalRule::kEdges) {
      const FourFloats aa = dot(a, a);
      const FourFloats bb = dot(b, b);
      const FourFloats cc = dot(c, c);
      weights = {size / (aa * bb), size / (aa * cc), size / (bb * cc)};
    }
    if (rule == NormalRule::kAngle || rule == NormalRule::kAreaAngle) {
      weights[0] = corner_angles(dot(a, b), size);
      weights[1] = corner_angles(none - dot(a, c), size);
      weights[2] = 3.14159265F - weights[0] - weights[1];
    }
    if (rule == NormalRule::kAreaAngle)
      for (FourFloats& weight : weights) weight = size * weight;
    for (std::size_t k = 0; k < 3; ++k) weights_[k] = is_face ? weights[k] : none;
  }

  void add_to(RuleSum& sum, std::size_t face, std::size_t corner) const noexcept {
    sum += RuleSum{unit_[0][face], unit_[1][face], unit_[2][face], 1} * weights_[corner][face];
  }

 private:
  FourVectors unit_;
  std::array<FourFloats, 3> weights_;
};

/// A power of two that brings the coordinates to 2 at most; 1 where one is infinite.
inline float position_scale(std::span<const float> positions) noexcept {
  float largest = 0;
  for (const float x : positions) largest = std::fabs(x) > largest ? std::fabs(x) : largest;
  if (!std::isfinite(largest)) return 1;
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::ldexp(1.0F, std::clamp(-exponent, -126, 126));
}

/// By vertex, over its faces in ascending order; degenerate faces add nothing. `triangles`: m x 3 indices;
/// `positions`: n x 3. O(n + m).
inline LargeVector<RuleSum> sum_by_rule(NormalRule rule, std::span<const std::uint32_t> triangles,
                                        std::span<const float> positions) {
  LargeVector<RuleSum> sums(positions.size() / 3, RuleSum{});
  const float scale = position_scale(positions);
  for (std::size_t f = 0; f < triangles.size(); f += 12) {
    // A place beyond the last takes the last face, and adds nothing.
    const std::size_t count = std::min<std::size_t>((triangles.size() - f) / 3, 4);
    std::array<const std::uint32_t*, 4> faces{};
    for (std::size_t i = 0; i < 4; ++i) faces[i] = triangles.data() + f + 3 * std::min(i, count - 1);
    const FourFaces four(rule, faces, positions.data(), scale);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t k = 0; k < 3; ++k) four.add_to(sums[faces[i][k]], i, k);
  }
  return sums;
}

}  // namespace deltamesh
