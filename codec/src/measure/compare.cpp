// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// All distances are taken in double precision and relative to A's origin, so that georeferenced maps lose
// nothing to large coordinates.
#include "deltamesh/compare.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "base/guard.h"
#include "base/numbers/vec3.h"
#include "base/try.h"
#include "connectivity/check_mesh.h"
#include "measure/attribute_comparison.h"
#include "measure/correspondence.h"
#include "measure/measure.h"
#include "measure/surface.h"
#include "measure/tree/triangle_tree.h"
#include "topology/adjacency.h"

namespace deltamesh {
namespace {

/// Gathers angles; pairs without a direction are left out.
class NormalAngles {
 public:
  void add(const Vec3& a, const Vec3& b) {
    if (a != Vec3{} && b != Vec3{}) degrees_.push_back(angle_degrees(a, b));
  }
  /// Sets mean and 95th percentile; not twice.
  void report(Comparison& result) {
    if (degrees_.empty()) return;
    const auto count = static_cast<double>(degrees_.size());
    result.normal_angle_mean = std::accumulate(degrees_.begin(), degrees_.end(), 0.0) / count;
    const auto rank = static_cast<std::ptrdiff_t>(std::ceil(0.95 * count)) - 1;
    std::nth_element(degrees_.begin(), degrees_.begin() + rank, degrees_.end());
    result.normal_angle_p95 = degrees_[static_cast<std::size_t>(rank)];
  }

 private:
  std::vector<double> degrees_;
};

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

/// Sets the distances, the angles of normals, the diagonal and the signed errors. Both meshes have passed
/// check_mesh(). O((n + m) log m). Errors: kInvalidArgument where one mesh is empty.
Result<void> compare_surfaces(const MeshView& a, const MeshView& b, const Roundings& roundings,
                              Comparison& result) {
  const Surface original(a, a.origin, roundings.a);
  const Surface approximation(b, a.origin, roundings.b);
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

/// A's vertices in B's sequence, with B's triangles: the mesh that B approximates vertex by vertex.
struct Reordered {
  Reordered(const MeshView& a, const MeshView& b, std::span<const float> rounded,
            std::span<const std::uint32_t> order)
      : positions(reordered(a.positions, order)), roundings(reordered(rounded, order)) {
    view.origin = a.origin;
    view.positions = positions;
    view.triangles = b.triangles;
  }
  Reordered(const Reordered&) = delete;
  Reordered& operator=(const Reordered&) = delete;

  /// Rows of three, or none.
  static std::vector<float> reordered(std::span<const float> rows, std::span<const std::uint32_t> order) {
    std::vector<float> result;
    if (rows.empty()) return result;
    result.reserve(3 * order.size());
    for (const std::uint32_t v : order) {
      const auto row = rows.subspan(v != kUnmatched ? std::size_t{3} * v : 0, 3);
      result.insert(result.end(), row.begin(), row.end());
    }
    return result;
  }

  std::vector<float> positions;
  std::vector<float> roundings;
  MeshView view;
};

void compare_vertices(const MeshView& a, const MeshView& b, std::span<const std::uint32_t> order,
                      const Roundings& roundings, Comparison& result) {
  const Reordered reordered(a, b, roundings.a, order);
  const Surface original(reordered.view, a.origin, reordered.roundings);
  result.diagonal = original.diagonal();
  std::vector<Vec3> decoded = positions_relative_to(a.origin, b, roundings.b);
  for (std::size_t v = 0; v < order.size(); ++v)
    if (order[v] == kUnmatched) decoded[v] = original.positions[v];  // counts as exact
  const std::vector<Vec3> decoded_normals = vertex_normals(decoded, b.triangles, original.weld_groups());

  const std::vector<std::uint32_t>& representative = original.weld.representative;
  std::vector<Vec3> from(representative.size());
  std::vector<Vec3> to(representative.size());
  NormalAngles angles;
  for (std::size_t g = 0; g < representative.size(); ++g) {
    const std::uint32_t v = representative[g];
    from[g] = original.positions[v];
    to[g] = decoded[v];
    if (!original.used[v]) continue;
    ++result.measured_vertices;
    angles.add(original.normals[v], decoded_normals[v]);
  }
  std::vector<std::uint32_t> welded(b.triangles.size());
  for (std::size_t i = 0; i < welded.size(); ++i) welded[i] = original.weld.geometric[b.triangles[i]];
  const Adjacency graph = build_adjacency(welded, static_cast<std::uint32_t>(representative.size()));
  result.quality = measure_quality(graph, from, to);
  angles.report(result);

  // Copies of a vertex may have drifted apart in B: the largest error counts them all.
  for (std::size_t v = 0; v < decoded.size(); ++v) {
    const Vec3 moved = decoded[v] - original.positions[v];
    result.quality.max_error = std::max(result.quality.max_error, length(moved));
    result.signed_error[v] = static_cast<float>(dot(moved, original.normals[v]));
  }
}

Result<void> check_order(std::span<const std::uint32_t> order, std::size_t a_vertices,
                         std::size_t b_vertices) {
  if (order.size() != b_vertices)
    return Error{.code = ErrorCode::kInvalidArgument,
                 .message = "the order must hold one index per vertex of the second mesh"};
  for (std::size_t i = 0; i < order.size(); ++i)
    if (order[i] >= a_vertices)
      return Error{.code = ErrorCode::kInvalidArgument,
                   .message = "the order names a vertex that the first mesh does not have",
                   .where_kind = WhereKind::kElement,
                   .where = i};
  return {};
}

Result<void> check_roundings(std::span<const float> roundings, const MeshView& mesh) {
  if (roundings.empty() || roundings.size() == mesh.positions.size()) return {};
  return Error{.code = ErrorCode::kInvalidArgument, .message = "roundings must be three for each vertex"};
}

Result<Comparison> compare_meshes(const MeshView& a, const MeshView& b, std::span<const std::uint32_t> order,
                                  const Roundings& roundings) {
  DELTAMESH_CHECK(check_mesh(a));
  DELTAMESH_CHECK(check_mesh(b));
  if (!order.empty()) DELTAMESH_CHECK(check_order(order, a.vertex_count(), b.vertex_count()));
  DELTAMESH_CHECK(check_roundings(roundings.a, a));
  DELTAMESH_CHECK(check_roundings(roundings.b, b));
  const AttributeComparer attributes(a, b);
  const Correspondence found = correspondence_of(a, b, order, attributes);
  Comparison result;
  result.signed_error.resize(b.vertex_count());
  result.corresponding = found.whole;
  result.reordered = found.reordered;
  result.matched_faces = found.faces;
  result.unmatched_faces_a = a.triangle_count() - found.faces;
  result.unmatched_faces_b = b.triangle_count() - found.faces;
  if (attributes.has_colors()) result.color_difference.resize(b.vertex_count());
  result.attributes = attributes.compare(found.pairs, result.color_difference);
  if (result.corresponding)
    compare_vertices(a, b, found.order, roundings, result);
  else
    DELTAMESH_CHECK(compare_surfaces(a, b, roundings, result));
  return result;
}

}  // namespace

Result<Comparison> compare(const MeshView& a, const MeshView& b, std::span<const std::uint32_t> order,
                           const Roundings& roundings) noexcept {
  return guarded([&] { return compare_meshes(a, b, order, roundings); }, "out of memory while comparing");
}

}  // namespace deltamesh
