// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "quality/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "quality/vertex_normals.h"

namespace deltamesh {
namespace {

Error bad_mesh(const char* message, WhereKind kind = WhereKind::kNone, std::uint64_t where = 0) {
  return {.code = ErrorCode::kInvalidMesh, .message = message, .where_kind = kind, .where = where};
}

}  // namespace

Result<void> check_surface(const MeshView& mesh) {
  if (mesh.positions.size() % 3 != 0 || mesh.triangles.size() % 3 != 0)
    return bad_mesh("positions and triangles must come in threes");
  constexpr auto kLargest = static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
  if (mesh.vertex_count() > kLargest || mesh.triangle_count() > kLargest)
    return Error{.code = ErrorCode::kLimitExceeded, .message = "more than 2^31 - 1 vertices or triangles"};
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    if (!std::isfinite(mesh.positions[i]))
      return bad_mesh("a coordinate is not a finite number", WhereKind::kVertex, i / 3);
  for (const double coordinate : mesh.origin)
    if (!std::isfinite(coordinate)) return bad_mesh("the origin is not a finite number");
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (mesh.triangles[i] >= mesh.vertex_count())
      return bad_mesh("a triangle names a vertex that does not exist", WhereKind::kTriangle, i / 3);
  return {};
}

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
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box box{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (!used[v]) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      box.min[k] = std::min(box.min[k], positions[v][k]);
      box.max[k] = std::max(box.max[k], positions[v][k]);
    }
  }
  return box.min[0] <= box.max[0] ? box.diagonal() : 0;
}

}  // namespace deltamesh
