// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "base/numbers/vec3.h"
#include "io/components.h"
#include "io/gltf_attributes.h"

namespace deltamesh {
namespace {

/// Sums of the triangles' normals, each as long as twice its area, n.
std::vector<Vec3> sum_normals(const Mesh& mesh) {
  const auto at = [&mesh](std::uint32_t v) {
    return Vec3{mesh.positions[3 * std::size_t{v}], mesh.positions[3 * std::size_t{v} + 1],
                mesh.positions[3 * std::size_t{v} + 2]};
  };
  std::vector<Vec3> sums(mesh.vertex_count());
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    const std::uint32_t* const t = &mesh.triangles[i];
    const Vec3 normal = cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0]));
    for (std::size_t k = 0; k < 3; ++k) sums[t[k]] = sums[t[k]] + normal;
  }
  return sums;
}

}  // namespace

void add_missing_normals(const std::vector<GltfVertexSet>& sets, Mesh& mesh) {
  const auto lacks = [](const GltfVertexSet& set) { return !set.semantics->contains("NORMAL"); };
  const auto normals = std::find_if(mesh.attributes.begin(), mesh.attributes.end(),
                                    [](const Attribute& a) { return a.kind == AttributeKind::kNormal; });
  if (normals == mesh.attributes.end() || std::none_of(sets.begin(), sets.end(), lacks)) return;
  const std::vector<Vec3> sums = sum_normals(mesh);
  for (const GltfVertexSet& set : sets) {
    if (!lacks(set)) continue;
    for (std::uint64_t v = set.first; v < set.first + set.count; ++v) {
      const double size = length(sums[v]);
      const bool has_direction = size > 0 && std::isfinite(size);
      const Vec3 normal = has_direction ? (1 / size) * sums[v] : Vec3{0, 0, 1};
      const std::array<float, 3> stored{to_float(normal[0]), to_float(normal[1]), to_float(normal[2])};
      std::memcpy(normals->values.data() + v * sizeof stored, stored.data(), sizeof stored);
    }
  }
}

}  // namespace deltamesh
