// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "stream/geometry.h"

#include <algorithm>
#include <map>

#include "base/numbers/vec3.h"

namespace deltamesh::gltf {

double smallest_diagonal_share(const Mesh& mesh, const std::vector<std::vector<std::uint32_t>>& corners,
                               const std::vector<PrimitiveSource>& sources, const StreamPlan& plan) {
  std::vector<Box> of_group(corners.size(), Box::empty());
  for (std::size_t g = 0; g < corners.size(); ++g)
    for (const std::uint32_t corner : corners[g])
      of_group[g].add(widen(&mesh.positions[3 * std::size_t{corner}]));
  Box all = Box::empty();
  std::map<std::size_t, Box> of_mesh;
  for (std::size_t i = 0; i < plan.primitives.size(); ++i) {
    const Box& box = of_group[plan.group_of[i]];
    if (box.is_empty()) continue;
    Box& whole = of_mesh.try_emplace(sources[plan.primitives[i]].number.mesh, Box::empty()).first->second;
    for (const Vec3& corner : {box.min, box.max}) {
      all.add(corner);
      whole.add(corner);
    }
  }
  const double whole = all.diagonal();
  double smallest = whole;
  for (const auto& [number, box] : of_mesh)
    if (box.diagonal() > 0) smallest = std::min(smallest, box.diagonal());
  return whole > 0 ? smallest / whole : 1;
}

}  // namespace deltamesh::gltf
