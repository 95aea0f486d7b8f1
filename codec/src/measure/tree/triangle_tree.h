// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Nearest point on a triangle soup: boxes of triangles in a tree.
#pragma once

#include <cstdint>
#include <span>

#include "base/numbers/vec3.h"
#include "measure/tree/box_tree.h"

namespace deltamesh {

/// A point of a triangle.
struct SurfacePoint {
  std::uint32_t triangle = 0;
  Vec3 weights{};  ///< barycentric, of the triangle's corners; none negative, sum 1
  Vec3 position{};
  double squared_distance = 0;  ///< from the point asked for
};

/// The point of triangle `a b c` nearest to `p`; degenerate triangles count as their edges. O(1).
SurfacePoint nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) noexcept;

/// Built in O(m log m); a query near the surface costs O(log m). `positions` and `triangles` must outlive it.
class TriangleTree {
 public:
  /// `positions`: n, finite; `triangles`: m x 3 indices below n, m from 1 to 2^31 - 1.
  TriangleTree(std::span<const Vec3> positions, std::span<const std::uint32_t> triangles);

  /// The nearest point of all triangles. `hint`: a triangle likely to be near, any below m; it saves time.
  SurfacePoint nearest(const Vec3& p, std::uint32_t hint = 0) const noexcept;

 private:
  SurfacePoint nearest_on(std::uint32_t triangle, const Vec3& p) const noexcept;

  std::span<const Vec3> positions_;
  std::span<const std::uint32_t> triangles_;
  BoxTree boxes_;
};

}  // namespace deltamesh
