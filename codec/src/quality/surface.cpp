// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "quality/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "quality/vertex_normals.h"

namespace deltamesh {

std::vector<Vec3> positions_relative_to(const std::array<double, 3>& origin, const MeshView& mesh) {
  const Vec3 offset = mesh.origin - origin;
  std::vector<Vec3> positions(mesh.vertex_count());
  for (std::size_t v = 0; v < positions.size(); ++v)
    positions[v] = offset + Vec3{mesh.positions[3 * v], mesh.positions[3 * v + 1], mesh.positions[3 * v + 2]};
  return positions;
}

Surface::Surface(const MeshView& mesh, const std::array<double, 3>& origin)
    : positions(positions_relative_to(origin, mesh)),
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

}  // namespace deltamesh
