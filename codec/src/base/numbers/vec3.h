// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Three doubles, and a box of them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace deltamesh {

using Vec3 = std::array<double, 3>;

constexpr Vec3 operator+(const Vec3& a, const Vec3& b) noexcept {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
constexpr Vec3 operator-(const Vec3& a, const Vec3& b) noexcept {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
constexpr Vec3 operator*(double s, const Vec3& a) noexcept { return {s * a[0], s * a[1], s * a[2]}; }
constexpr double dot(const Vec3& a, const Vec3& b) noexcept {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
constexpr Vec3 cross(const Vec3& a, const Vec3& b) noexcept {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// The first three numbers, exactly. `Numbers`: floats or integers, by index.
template <class Numbers>
constexpr Vec3 widen(const Numbers& numbers) noexcept {
  return {static_cast<double>(numbers[0]), static_cast<double>(numbers[1]), static_cast<double>(numbers[2])};
}
/// Rows of three.
inline std::vector<Vec3> widen_rows(std::span<const float> rows) {
  std::vector<Vec3> widened(rows.size() / 3);
  for (std::size_t i = 0; i < widened.size(); ++i) widened[i] = widen(&rows[3 * i]);
  return widened;
}
/// Of two points, each as for widen().
template <class A, class B>
constexpr double squared_distance(const A& a, const B& b) noexcept {
  const Vec3 way = widen(a) - widen(b);
  return dot(way, way);
}
inline double length(const Vec3& a) noexcept { return std::sqrt(dot(a, a)); }

/// Scales `v` to unit length and returns what it is multiplied by, above 0. 0 where it has no direction: then
/// `v` stays.
inline double normalize(Vec3& v) noexcept {
  const double square = dot(v, v);
  if (!(square > 1e-300) || !(square < 1e300)) return 0;
  const double inverse = 1 / std::sqrt(square);
  v = inverse * v;
  return inverse;
}

/// Axis-aligned, closed.
struct Box {
  Vec3 min{};
  Vec3 max{};

  /// Around nothing: add() makes it the box of what is added.
  static constexpr Box empty() noexcept {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return {{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  }
  /// The bounding box of `points`; the point 0 if there are none.
  static Box around(std::span<const Vec3> points) noexcept {
    Box box = points.empty() ? Box{} : empty();
    for (const Vec3& point : points) box.add(point);
    return box;
  }
  bool is_empty() const noexcept { return min[0] > max[0]; }
  void add(const Vec3& p) noexcept {
    for (std::size_t k = 0; k < 3; ++k) {
      min[k] = std::min(min[k], p[k]);
      max[k] = std::max(p[k], max[k]);
    }
  }
  double longest_side() const noexcept {
    return std::fmax(max[0] - min[0], std::fmax(max[1] - min[1], max[2] - min[2]));
  }
  std::size_t longest_axis() const noexcept {
    const Vec3 side = max - min;
    return static_cast<std::size_t>(std::max_element(side.begin(), side.end()) - side.begin());
  }
  double diagonal() const noexcept { return length(max - min); }
};

}  // namespace deltamesh
