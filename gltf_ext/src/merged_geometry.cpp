// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "merged_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>

#include "base/numbers/vec3.h"

namespace deltamesh::gltf {
namespace {

Vec3 position_of(const Mesh& mesh, std::uint32_t vertex) noexcept {
  const float* p = &mesh.positions[vertex * std::size_t{3}];
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

struct Bounds {
  Vec3 low{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  Vec3 high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  void add(const Vec3& p) noexcept {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  void add(const Bounds& other) noexcept {
    add(other.low);
    add(other.high);
  }
  double diagonal() const noexcept { return length(high - low); }
};

}  // namespace

void write_face_normals(const Mesh& mesh, std::span<const std::uint32_t> corners,
                        std::span<std::byte> normals) {
  std::map<std::uint32_t, Vec3> sums;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const auto c = corners.subspan(i, 3);
    const Vec3 first = position_of(mesh, c[0]);
    const Vec3 normal = cross(position_of(mesh, c[1]) - first, position_of(mesh, c[2]) - first);
    for (const std::uint32_t corner : c) sums[corner] = sums[corner] + normal;
  }
  for (const auto& [vertex, sum] : sums) {
    const double size = length(sum);
    if (!(size > 0) || !std::isfinite(size)) continue;
    std::array<float, 3> unit{};
    for (std::size_t k = 0; k < 3; ++k) unit[k] = static_cast<float>(sum[k] / size);
    std::memcpy(normals.data() + vertex * sizeof unit, unit.data(), sizeof unit);
  }
}

double smallest_diagonal_share(const Mesh& mesh, const std::vector<std::vector<std::uint32_t>>& corners,
                               const std::vector<PrimitiveSource>& sources, const StreamPlan& plan) {
  std::vector<Bounds> of_group(corners.size());
  for (std::size_t g = 0; g < corners.size(); ++g)
    for (const std::uint32_t corner : corners[g]) of_group[g].add(position_of(mesh, corner));
  Bounds all;
  std::map<std::size_t, Bounds> of_mesh;
  for (std::size_t i = 0; i < plan.primitives.size(); ++i) {
    const Bounds& bounds = of_group[plan.group_of[i]];
    all.add(bounds);
    of_mesh[sources[plan.primitives[i]].mesh].add(bounds);
  }
  const double whole = all.diagonal();
  double smallest = whole;
  for (const auto& [number, bounds] : of_mesh)
    if (bounds.diagonal() > 0) smallest = std::min(smallest, bounds.diagonal());
  return whole > 0 ? smallest / whole : 1;
}

}  // namespace deltamesh::gltf
