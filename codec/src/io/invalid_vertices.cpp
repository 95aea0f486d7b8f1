// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/invalid_vertices.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace deltamesh {
namespace {

bool is_finite(const Mesh& mesh, std::size_t vertex) noexcept {
  const float* const p = &mesh.positions[3 * vertex];
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

}  // namespace

void drop_invalid_faces(Imported& imported) {
  Mesh& mesh = imported.mesh;
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto corners = std::span(mesh.triangles).subspan(3 * t, 3);
    if (!std::all_of(corners.begin(), corners.end(), [&](std::uint32_t v) { return is_finite(mesh, v); }))
      continue;
    std::copy(corners.begin(), corners.end(), &mesh.triangles[3 * kept]);
    if (!mesh.face_groups.empty()) mesh.face_groups[kept] = mesh.face_groups[t];
    ++kept;
  }
  imported.report.leave_out(LeftOutKind::kFaces, "at vertices that are not finite",
                            mesh.triangle_count() - kept);
  mesh.triangles.resize(3 * kept);
  if (!mesh.face_groups.empty()) mesh.face_groups.resize(kept);
}

void drop_invalid_unused(Imported& imported) {
  Mesh& mesh = imported.mesh;
  if (std::all_of(mesh.positions.begin(), mesh.positions.end(), [](float x) { return std::isfinite(x); }))
    return;
  const std::size_t count = mesh.vertex_count();
  std::vector<bool> dropped(count);
  for (std::size_t v = 0; v < count; ++v) dropped[v] = !is_finite(mesh, v);
  for (const std::uint32_t v : mesh.triangles) dropped[v] = false;
  const auto drops = static_cast<std::uint64_t>(std::count(dropped.begin(), dropped.end(), true));
  if (drops == 0) return;
  imported.report.leave_out(LeftOutKind::kElements, "vertices that are not finite and that no face uses",
                            drops);

  std::vector<float>& roundings = imported.roundings;
  std::vector<std::uint32_t> renamed(count);
  std::size_t kept = 0;
  for (std::size_t v = 0; v < count; ++v) {
    if (dropped[v]) continue;
    renamed[v] = static_cast<std::uint32_t>(kept);
    std::copy_n(&mesh.positions[3 * v], 3, &mesh.positions[3 * kept]);
    if (!roundings.empty()) std::copy_n(&roundings[3 * v], 3, &roundings[3 * kept]);
    for (Attribute& attribute : mesh.attributes) {
      const std::size_t size = attribute.components * component_size(attribute.type);
      std::memmove(&attribute.values[kept * size], &attribute.values[v * size], size);
    }
    ++kept;
  }
  mesh.positions.resize(3 * kept);
  if (!roundings.empty()) roundings.resize(3 * kept);
  for (Attribute& attribute : mesh.attributes)
    attribute.values.resize(kept * attribute.components * component_size(attribute.type));
  for (std::uint32_t& v : mesh.triangles) v = renamed[v];
}

}  // namespace deltamesh
