// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "measure/surface.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace deltamesh {

std::vector<Vec3> positions_relative_to(const std::array<double, 3>& origin, const MeshView& mesh,
                                        std::span<const float> roundings) {
  const Vec3 offset = mesh.origin - origin;
  std::vector<Vec3> positions(mesh.vertex_count());
  for (std::size_t v = 0; v < positions.size(); ++v) positions[v] = offset + widen(&mesh.positions[3 * v]);
  for (std::size_t v = 0; 3 * v < roundings.size(); ++v)
    positions[v] = positions[v] + widen(&roundings[3 * v]);
  return positions;
}

Surface::Surface(const MeshView& mesh, const std::array<double, 3>& origin, std::span<const float> roundings)
    : positions(positions_relative_to(origin, mesh, roundings)),
      used(mesh.vertex_count()),
      triangles(mesh.triangles.begin(), mesh.triangles.end()) {
  if (triangles.empty())
    for (std::uint32_t v = 0; v < positions.size(); ++v) triangles.insert(triangles.end(), 3, v);
  for (const std::uint32_t v : triangles) used[v] = 1;
  weld = weld_by_position(mesh.positions, used);
  normals = vertex_normals(positions, triangles, weld_groups());
}

std::vector<std::uint32_t> Surface::weld_groups() const {
  std::vector<std::uint32_t> groups(weld.geometric.size());
  for (std::size_t v = 0; v < groups.size(); ++v) groups[v] = weld.representative[weld.geometric[v]];
  return groups;
}

double Surface::diagonal() const {
  Box box = Box::empty();
  for (std::size_t v = 0; v < positions.size(); ++v)
    if (used[v]) box.add(positions[v]);
  return box.is_empty() ? 0 : box.diagonal();
}

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
