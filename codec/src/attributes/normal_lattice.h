// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Directions around a predicted one as points of a hexagonal lattice in the stereographic plane [ATTR-24].
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "base/vec3.h"

namespace deltamesh {

/// Of a lattice point: `row` along the frame's first axis, `place` along the second.
struct LatticePoint {
  std::int32_t row = 0;
  std::int32_t place = 0;
  friend bool operator==(const LatticePoint&, const LatticePoint&) = default;
};

/// Three orthogonal unit vectors.
struct NormalFrame {
  Vec3 pole;  ///< the predicted normal
  Vec3 first;
  Vec3 second;
};

/// Rows are 1.5 radii apart, the points of a row sqrt(3), and odd rows are shifted by half of that: no point
/// of the plane is further than the radius from a lattice point.
///
///     *     *     *      row 1
///        *     *     *   row 0
class NormalLattice {
 public:
  /// `radius`: of the stereographic plane, where a unit is an angle of 90 degrees from the pole.
  explicit NormalLattice(double radius) noexcept
      : radius_(radius), row_(1.5 * radius), place_(kSqrt3 * radius) {}

  std::array<double, 2> at(const LatticePoint& point) const noexcept {
    const double half = (point.row & 1) != 0 ? 0.5 : 0.0;
    return {row_ * point.row, place_ * (point.place + half)};
  }

  double radius() const noexcept { return radius_; }
  double row_distance() const noexcept { return row_; }
  double place_distance() const noexcept { return place_; }

 private:
  static constexpr double kSqrt3 = 1.7320508075688772;
  double radius_;
  double row_;
  double place_;
};

/// The direction of a point of the plane. Within distance 1 of the origin the projection is stereographic
/// from the pole; from there to distance 2 it is so from the pole's opposite, the distance taken from 2. From
/// 2 to 3 it is the pole's opposite, false beyond.
inline bool direction_at(const NormalFrame& frame, const std::array<double, 2>& x, Vec3& direction) noexcept {
  double a = x[0];
  double b = x[1];
  double square = a * a + b * b;
  double way = 1;
  if (!(square <= 1)) {
    if (!(square <= 9)) return false;
    const double distance = std::sqrt(square);
    const double scale = distance < 2 ? (2 - distance) / distance : 0;
    a = scale * a;
    b = scale * b;
    square = a * a + b * b;
    way = -1;
  }
  const double inverse = 1 / (1 + square);
  const double p = way * (1 - square) * inverse;
  const double u = 2 * a * inverse;
  const double v = 2 * b * inverse;
  for (std::size_t c = 0; c < 3; ++c)
    direction[c] = p * frame.pole[c] + u * frame.first[c] + v * frame.second[c];
  return true;
}

/// The point of a direction, a unit vector; inverse of direction_at().
inline std::array<double, 2> point_of(const NormalFrame& frame, const Vec3& direction) noexcept {
  const double p = dot(frame.pole, direction);
  const double u = dot(frame.first, direction);
  const double v = dot(frame.second, direction);
  if (p >= 0) return {u / (1 + p), v / (1 + p)};
  const double a = u / (1 - p);
  const double b = v / (1 - p);
  const double distance = std::sqrt(a * a + b * b);
  if (distance == 0) return {2, 0};
  const double scale = (2 - distance) / distance;
  return {scale * a, scale * b};
}

}  // namespace deltamesh
