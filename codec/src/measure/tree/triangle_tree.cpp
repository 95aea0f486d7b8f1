// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "measure/tree/triangle_tree.h"

#include <algorithm>
#include <array>

namespace deltamesh {
namespace {

/// Nearest point of the segment from corner i to corner j, as weights of the corners.
Vec3 nearest_on_edge(const Vec3& p, const std::array<Vec3, 3>& corners, std::size_t i,
                     std::size_t j) noexcept {
  const Vec3 along = corners[j] - corners[i];
  const double squared = dot(along, along);
  const double t = squared > 0 ? std::clamp(dot(p - corners[i], along) / squared, 0.0, 1.0) : 0.0;
  Vec3 weights{};
  weights[i] = 1 - t;
  weights[j] = t;
  return weights;
}

SurfacePoint at_weights(const Vec3& p, const std::array<Vec3, 3>& corners, const Vec3& weights) noexcept {
  SurfacePoint point;
  point.weights = weights;
  point.position = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
  const Vec3 apart = p - point.position;
  point.squared_distance = dot(apart, apart);
  return point;
}

}  // namespace

SurfacePoint nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) noexcept {
  const std::array<Vec3, 3> corners{a, b, c};
  const Vec3 normal = cross(b - a, c - a);
  const double squared = dot(normal, normal);
  if (squared > 0) {
    // Signed areas of the sub-triangles over the whole: the weights of the foot of the perpendicular.
    const double weight_b = dot(cross(p - a, c - a), normal) / squared;
    const double weight_c = dot(cross(b - a, p - a), normal) / squared;
    const double weight_a = 1 - weight_b - weight_c;
    if (weight_a >= 0 && weight_b >= 0 && weight_c >= 0)
      return at_weights(p, corners, {weight_a, weight_b, weight_c});
  }
  SurfacePoint best = at_weights(p, corners, nearest_on_edge(p, corners, 0, 1));
  for (const std::size_t i : {std::size_t{1}, std::size_t{2}}) {
    const SurfacePoint other = at_weights(p, corners, nearest_on_edge(p, corners, i, (i + 1) % 3));
    if (other.squared_distance < best.squared_distance) best = other;
  }
  return best;
}

TriangleTree::TriangleTree(std::span<const Vec3> positions, std::span<const std::uint32_t> triangles)
    : positions_(positions), triangles_(triangles), boxes_(positions, triangles, 3) {}

SurfacePoint TriangleTree::nearest_on(std::uint32_t triangle, const Vec3& p) const noexcept {
  const std::size_t first = 3 * std::size_t{triangle};
  SurfacePoint point = nearest_on_triangle(
      p, positions_[triangles_[first]], positions_[triangles_[first + 1]], positions_[triangles_[first + 2]]);
  point.triangle = triangle;
  return point;
}

SurfacePoint TriangleTree::nearest(const Vec3& p, std::uint32_t hint) const noexcept {
  SurfacePoint best = nearest_on(hint, p);
  boxes_.visit_near(
      p, [&](double squared_distance) { return squared_distance >= best.squared_distance; },
      [&](std::uint32_t triangle) {
        if (const SurfacePoint point = nearest_on(triangle, p);
            point.squared_distance < best.squared_distance)
          best = point;
      });
  return best;
}

}  // namespace deltamesh
