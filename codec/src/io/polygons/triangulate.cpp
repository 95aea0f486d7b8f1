// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/polygons/triangulate.h"

#include <bit>
#include <cmath>
#include <optional>

#include "io/polygons/orientation.h"

namespace deltamesh {
namespace {

/// Newell's normal: twice the areas of the polygon's shadows on the three planes.
Vec3 area_normal(std::span<const Vec3> points) noexcept {
  Vec3 normal{};
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
    normal = normal + cross(points[i] - points[0], points[i + 1] - points[0]);
  return normal;
}

/// The polygon seen along the axis nearest to its normal, turning to the left. Empty where it has no area.
std::vector<Vec2> flatten(std::span<const Vec3> points) {
  const Vec3 normal = area_normal(points);
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::fabs(normal[k]) > std::fabs(normal[axis])) axis = k;
  std::vector<Vec2> flat;
  if (!std::isfinite(normal[axis]) || normal[axis] == 0) return flat;
  std::size_t u = (axis + 1) % 3;
  std::size_t v = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(u, v);
  flat.reserve(points.size());
  for (const Vec3& point : points) flat.push_back({point[u], point[v]});
  return flat;
}

bool fan_fills(std::span<const Vec2> points) noexcept {
  for (std::size_t i = 2; i < points.size(); ++i)
    if (orientation(points[0], points[i - 1], points[i]) <= 0) return false;
  return true;
}

/// Some of a polygon's corners, one bit each: to find one costs little where hardly any are left.
class CornerSet {
 public:
  explicit CornerSet(std::size_t corners) : words_((corners + 63) / 64) {}

  void set(std::uint32_t i, bool is_in) noexcept {
    const std::uint64_t bit = std::uint64_t{1} << i % 64;
    words_[i / 64] = is_in ? words_[i / 64] | bit : words_[i / 64] & ~bit;
  }
  bool contains(std::uint32_t i) const noexcept { return (words_[i / 64] >> i % 64 & 1) != 0; }

  /// The first from `at` on, around the polygon.
  std::optional<std::uint32_t> first_from(std::uint32_t at) const noexcept {
    std::size_t w = at / 64;
    std::uint64_t word = words_[w] & ~std::uint64_t{0} << at % 64;
    for (std::size_t step = 0; word == 0 && step < words_.size(); ++step) {
      w = (w + 1) % words_.size();
      word = words_[w];
    }
    if (word == 0) return std::nullopt;
    return static_cast<std::uint32_t>(64 * w) + static_cast<std::uint32_t>(std::countr_zero(word));
  }

 private:
  std::vector<std::uint64_t> words_;
};

class Ears {
 public:
  explicit Ears(std::span<const Vec2> points)
      : points_(points), sticks_out_(points.size()), is_ear_(points.size()) {
    const auto n = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      next_.push_back((i + 1) % n);
      previous_.push_back((i + n - 1) % n);
    }
    for (std::uint32_t i = 0; i < n; ++i)
      if (turn(i) <= 0) hollow_.push_back(i);
    for (std::uint32_t i = 0; i < n; ++i) look_at(i);
  }

  void cut(std::vector<std::uint32_t>& triangles) {
    std::uint32_t at = 0;
    for (std::size_t left = points_.size(); left > 2; --left) {
      const std::uint32_t tip = find_tip(at);
      const std::uint32_t before = previous_[tip];
      const std::uint32_t after = next_[tip];
      triangles.insert(triangles.end(), {before, tip, after});
      next_[before] = after;
      previous_[after] = before;
      next_[tip] = tip;
      sticks_out_.set(tip, false);
      is_ear_.set(tip, false);
      // Cutting an ear off changes no other corner's being one: O'Rourke, 1.6.5.
      look_at(before);
      look_at(after);
      at = next_[after];  // not `after`: ears of one corner after the other make slivers
    }
  }

 private:
  int turn(std::uint32_t i) const noexcept {
    return orientation(points_[previous_[i]], points_[i], points_[next_[i]]);
  }

  void look_at(std::uint32_t i) noexcept {
    sticks_out_.set(i, turn(i) > 0);
    is_ear_.set(i, sticks_out_.contains(i) && is_empty(i));
  }

  /// Whether no hollow corner of what is left lies in the triangle of corner `i`, which sticks out, or on its
  /// sides. Points equal to its own corners, as at a bridge to a hole, do not count.
  bool is_empty(std::uint32_t i) const noexcept {
    const Vec2& a = points_[previous_[i]];
    const Vec2& b = points_[i];
    const Vec2& c = points_[next_[i]];
    const Vec2 low{std::fmin(a[0], std::fmin(b[0], c[0])), std::fmin(a[1], std::fmin(b[1], c[1]))};
    const Vec2 high{std::fmax(a[0], std::fmax(b[0], c[0])), std::fmax(a[1], std::fmax(b[1], c[1]))};
    for (const std::uint32_t other : hollow_) {
      const Vec2& p = points_[other];
      if (p[0] < low[0] || p[0] > high[0] || p[1] < low[1] || p[1] > high[1]) continue;
      if (next_[other] == other || p == a || p == b || p == c) continue;
      if (orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0) return false;
    }
    return true;
  }

  /// The first ear from `at` on. Where none is left, as in what crosses itself: the first corner that sticks
  /// out, or `at`.
  std::uint32_t find_tip(std::uint32_t at) const noexcept {
    if (const auto ear = is_ear_.first_from(at)) return *ear;
    return sticks_out_.first_from(at).value_or(at);
  }

  std::span<const Vec2> points_;
  std::vector<std::uint32_t> next_,
      previous_;  // of corners that are left; a corner that was cut off is its own next one
  std::vector<std::uint32_t>
      hollow_;                     // that turned to the right or not at all in the beginning; others never do
  CornerSet sticks_out_, is_ear_;  // of corners that are left
};

}  // namespace

bool triangulate(std::span<const Vec3> points, std::vector<std::uint32_t>& triangles) {
  const std::vector<Vec2> flat = points.size() > 3 ? flatten(points) : std::vector<Vec2>{};
  const bool is_fan = flat.empty() || fan_fills(flat);
  if (!is_fan && points.size() <= kMostEarCorners) {
    Ears(flat).cut(triangles);
    return true;
  }
  for (std::uint32_t i = 2; i < points.size(); ++i) triangles.insert(triangles.end(), {0, i - 1, i});
  return is_fan;
}

}  // namespace deltamesh
