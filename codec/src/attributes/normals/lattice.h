// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Directions around a predicted one as points of a plane, and a hexagonal lattice in it [ATTR-24]. Floats, +
// -
// * / and square roots in the order written: the same bits on every machine.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "base/numbers/vec3.h"
#include "base/simd/four_floats.h"

namespace deltamesh {

/// Three orthogonal unit vectors; fourth lanes are not used.
struct NormalFrame {
  FourFloats pole;  ///< the predicted normal
  FourFloats first;
  FourFloats second;
};

/// `pole`: of any length, its square above 1e-12 and below 1e36. The first axis is as near to `way` as it
/// goes.
inline NormalFrame make_frame(FourFloats pole, FourFloats way) noexcept {
  const float square = dot3(pole, pole);
  FourFloats second = cross3(pole, way);
  float second_square = dot3(second, second);
  if (!(second_square > 1e-12F * square && second_square < 1e36F)) {
    const float x = std::fabs(pole[0]);
    const float y = std::fabs(pole[1]);
    const float z = std::fabs(pole[2]);
    const bool is_x = x <= y && x <= z;
    const bool is_y = !is_x && y <= z;
    second = cross3(pole, FourFloats{is_x ? 1.0F : 0.0F, is_y ? 1.0F : 0.0F, is_x || is_y ? 0.0F : 1.0F, 0});
    second_square = dot3(second, second);
  }
  const FourFloats inverse = 1 / square_roots(FourFloats{square, second_square, 1, 1});
  NormalFrame frame;
  frame.pole = pole * inverse[0];
  frame.second = second * inverse[1];
  frame.first = cross3(frame.second, frame.pole);
  return frame;
}

/// A point of the plane that directions around a pole are projected to.
using PlanePoint = std::array<float, 2>;

/// The direction of a point of the plane. Within distance 1 of the origin the projection is stereographic
/// from the pole; from there to distance 2 it is so from the pole's opposite, the distance taken from 2. From
/// 2 to 3 it is the pole's opposite, false beyond.
inline bool direction_at(const NormalFrame& frame, PlanePoint x, FourFloats& direction) noexcept {
  float square = x[0] * x[0] + x[1] * x[1];
  float way = 1;
  if (!(square <= 1)) {
    if (!(square <= 9)) return false;
    const float distance = std::sqrt(square);
    const float scale = distance < 2 ? (2 - distance) / distance : 0;
    x = {scale * x[0], scale * x[1]};
    square = x[0] * x[0] + x[1] * x[1];
    way = -1;
  }
  const float inverse = 1 / (1 + square);
  direction = (way * (1 - square) * inverse) * frame.pole + (2 * x[0] * inverse) * frame.first +
              (2 * x[1] * inverse) * frame.second;
  return true;
}

/// The point of a direction, a unit vector; inverse of direction_at(). For writers.
inline std::array<double, 2> point_of(const NormalFrame& frame, const Vec3& direction) noexcept {
  const double p = dot(widen(frame.pole), direction);
  const double u = dot(widen(frame.first), direction);
  const double v = dot(widen(frame.second), direction);
  if (p >= 0) return {u / (1 + p), v / (1 + p)};
  const double a = u / (1 - p);
  const double b = v / (1 - p);
  const double distance = std::sqrt(a * a + b * b);
  if (distance == 0) return {2, 0};
  const double scale = (2 - distance) / distance;
  return {scale * a, scale * b};
}

/// Coordinates of a lattice point: `row` along the frame's first axis, `place` along the second.
struct LatticePoint {
  std::int32_t row = 0;
  std::int32_t place = 0;
  friend bool operator==(const LatticePoint&, const LatticePoint&) = default;
};

/// Rows are 1.5 radii apart, the points of a row sqrt(3), and odd rows are shifted by half of that: no point
/// of the plane is further than the radius from a lattice point.
///
///     *     *     *      row 1
///        *     *     *   row 0
class NormalLattice {
 public:
  /// `radius`: of the stereographic plane, where a unit is an angle of 90 degrees from the pole.
  explicit NormalLattice(float radius) noexcept : radius_(radius) {}

  /// The place of a point, in radii.
  static PlanePoint in_radii(const LatticePoint& point) noexcept {
    const float half = (point.row & 1) != 0 ? 0.5F : 0.0F;
    return {kRow * static_cast<float>(point.row), kPlace * (static_cast<float>(point.place) + half)};
  }
  PlanePoint at(const LatticePoint& point) const noexcept {
    const PlanePoint x = in_radii(point);
    return {radius_ * x[0], radius_ * x[1]};
  }

  double radius() const noexcept { return radius_; }
  double row_distance() const noexcept { return static_cast<double>(kRow) * radius(); }
  double place_distance() const noexcept { return static_cast<double>(kPlace) * radius(); }

 private:
  static constexpr float kRow = 1.5F;
  static constexpr float kPlace = 1.7320508F;
  float radius_;
};

}  // namespace deltamesh
