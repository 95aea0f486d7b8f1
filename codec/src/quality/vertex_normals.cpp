// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "quality/vertex_normals.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace deltamesh {

Vec3 unit_or_zero(const Vec3& v) noexcept {
  const double norm = length(v);
  return norm > std::numeric_limits<double>::min() ? (1 / norm) * v : Vec3{};
}

std::vector<Vec3> vertex_normals(std::span<const Vec3> positions, std::span<const std::uint32_t> triangles,
                                 std::span<const std::uint32_t> group) {
  std::vector<Vec3> sums(positions.size());
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const Vec3& a = positions[triangles[i]];
    const Vec3 normal = cross(positions[triangles[i + 1]] - a, positions[triangles[i + 2]] - a);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Vec3& sum = sums[group[triangles[i + corner]]];
      sum = sum + normal;
    }
  }
  std::vector<Vec3> normals(positions.size());
  for (std::size_t v = 0; v < normals.size(); ++v) normals[v] = unit_or_zero(sums[group[v]]);
  return normals;
}

double angle_degrees(const Vec3& a, const Vec3& b) noexcept {
  return std::atan2(length(cross(a, b)), dot(a, b)) * 180 / std::numbers::pi;
}

}  // namespace deltamesh
