// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "quality/surface_distance.h"

#include <algorithm>
#include <cmath>

#include "quality/normal_angles.h"
#include "quality/surface.h"
#include "quality/triangle_tree.h"
#include "quality/vertex_normals.h"

namespace deltamesh {
namespace {

/// Distances of the vertices of one mesh to the surface of the other, summed up.
struct DistanceSum {
  double squares = 0;
  double largest_square = 0;
  std::uint64_t count = 0;

  void add(double square) {
    squares += square;
    largest_square = std::max(largest_square, square);
    ++count;
  }
};

/// Calls visit(vertex, nearest point of `surface`) for every vertex that counts of `from`.
template <class Visit>
void for_each_nearest(const Surface& from, const Surface& surface, Visit visit) {
  const TriangleTree tree(surface.positions, surface.triangles);
  std::uint32_t hint = 0;
  for (std::size_t v = 0; v < from.positions.size(); ++v) {
    if (!from.used[v]) continue;
    const SurfacePoint point = tree.nearest(from.positions[v], hint);
    hint = point.triangle;
    visit(v, point);
  }
}

Vec3 normal_at(const Surface& surface, const SurfacePoint& point) {
  Vec3 sum{};
  for (std::size_t corner = 0; corner < 3; ++corner)
    sum = sum + point.weights[corner] *
                    surface.normals[surface.triangles[3 * std::size_t{point.triangle} + corner]];
  return unit_or_zero(sum);
}

}  // namespace

Result<void> compare_surfaces(const MeshView& a, const MeshView& b, Comparison& result) {
  const Surface original(a, a.origin);
  const Surface approximation(b, a.origin);
  result.diagonal = original.diagonal();
  if (original.triangles.empty() || approximation.triangles.empty())
    return Error{.code = ErrorCode::kInvalidArgument, .message = "one mesh is empty, the other is not"};
  DistanceSum distances;
  NormalAngles angles;
  for_each_nearest(approximation, original, [&](std::size_t v, const SurfacePoint& point) {
    distances.add(point.squared_distance);
    const Vec3 normal = normal_at(original, point);
    result.signed_error[v] = static_cast<float>(dot(approximation.positions[v] - point.position, normal));
    if (approximation.weld.representative[approximation.weld.geometric[v]] == v)
      angles.add(normal, approximation.normals[v]);
  });
  for_each_nearest(original, approximation,
                   [&](std::size_t, const SurfacePoint& point) { distances.add(point.squared_distance); });
  result.surface_rms = std::sqrt(distances.squares / static_cast<double>(distances.count));
  result.surface_max = std::sqrt(distances.largest_square);
  angles.report(result);
  return {};
}

}  // namespace deltamesh
