// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// All distances are taken in double precision and relative to A's origin, so that georeferenced maps lose
// nothing to large coordinates.
#include "deltamesh/compare.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <numeric>

#include "base/try.h"
#include "base/vec3.h"
#include "quality/attribute_comparison.h"
#include "quality/correspondence.h"
#include "quality/face_matching.h"
#include "quality/far_matches.h"
#include "quality/measure.h"
#include "quality/normal_angles.h"
#include "quality/surface.h"
#include "quality/surface_distance.h"
#include "quality/vertex_normals.h"
#include "topology/adjacency.h"

namespace deltamesh {
namespace {

/// A's vertices in B's sequence, with B's triangles: the mesh that B approximates vertex by vertex.
struct Reordered {
  Reordered(const MeshView& a, const MeshView& b, std::span<const std::uint32_t> order)
      : positions(3 * order.size()) {
    for (std::size_t v = 0; v < order.size(); ++v)
      std::copy_n(a.positions.begin() + 3 * static_cast<std::ptrdiff_t>(order[v]), 3,
                  positions.begin() + 3 * static_cast<std::ptrdiff_t>(v));
    view.origin = a.origin;
    view.positions = positions;
    view.triangles = b.triangles;
  }
  Reordered(const Reordered&) = delete;
  Reordered& operator=(const Reordered&) = delete;

  std::vector<float> positions;
  MeshView view;
};

void compare_vertices(const MeshView& a, const MeshView& b, std::span<const std::uint32_t> order,
                      Comparison& result) {
  const Reordered reordered(a, b, order);
  const Surface original(reordered.view, a.origin);
  result.diagonal = original.diagonal();
  const std::vector<Vec3> decoded = positions_relative_to(a.origin, b);
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

/// Vertices of A and B that stand for each other.
struct Correspondence {
  bool whole = false;  ///< all faces of both, and every vertex of B
  bool reordered = false;
  std::vector<std::uint32_t> order;  ///< a vertex of A at the place of each of B's; only where whole
  std::vector<VertexPair> pairs;     ///< at the corners of matched faces, each once
  std::uint64_t faces = 0;           ///< matched ones
};

Correspondence by_order(const MeshView& a, const MeshView& b, std::span<const std::uint32_t> order) {
  Correspondence found;
  found.whole = order.size() == b.vertex_count() &&
                triangles_correspond(a.triangles, a.vertex_count(), b.triangles, order);
  if (!found.whole) return found;
  found.order.assign(order.begin(), order.end());
  found.faces = b.triangle_count();
  std::vector<std::uint8_t> used(b.vertex_count(), b.triangles.empty() ? 1 : 0);
  for (const std::uint32_t v : b.triangles) used[v] = 1;
  for (std::uint32_t v = 0; v < used.size(); ++v)
    if (used[v] != 0) found.pairs.push_back({.a = order[v], .b = v});
  return found;
}

/// The vertex of A for every vertex of B; empty where a vertex of B has none, or is at several places of A.
std::vector<std::uint32_t> order_of(const FaceGraph& a, const FaceGraph& b,
                                    std::span<const FaceMatch> matches) {
  constexpr std::uint32_t kNone = 0xffffffff;
  std::vector<std::uint32_t> welded(b.positions.size(), kNone);
  std::vector<std::uint32_t> order(b.positions.size());
  for (std::size_t f = 0; f < matches.size(); ++f) {
    if (matches[f].face == kNoFace) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t corner = 3 * std::size_t{matches[f].face} + (k + matches[f].turn) % 3;
      const std::uint32_t v = b.vertices[3 * f + k];
      if (welded[v] != kNone && welded[v] != a.corners[corner]) return {};
      welded[v] = a.corners[corner];
      order[v] = a.vertices[corner];
    }
  }
  if (std::find(welded.begin(), welded.end(), kNone) != welded.end()) return {};
  return order;
}

/// Whether both have the same faces, but for those that draw nothing as two corners are at one place.
bool all_match(const FaceGraph& a, const FaceGraph& b, std::span<const FaceMatch> matches) {
  std::vector<std::uint8_t> taken(a.face_count());
  for (std::uint32_t f = 0; f < b.real_faces; ++f) {
    if (matches[f].face != kNoFace)
      taken[matches[f].face] = 1;
    else if (!b.is_degenerate(f))
      return false;
  }
  for (std::uint32_t f = 0; f < a.real_faces; ++f)
    if (taken[f] == 0 && !a.is_degenerate(f)) return false;
  return true;
}

Correspondence by_faces(const MeshView& mesh_a, const MeshView& mesh_b, const AttributeComparer& attributes) {
  const FaceGraph a(mesh_a, mesh_a.origin);
  const FaceGraph b(mesh_b, mesh_a.origin);
  std::vector<FaceMatch> matches = match_faces(
      a, b, [&](std::uint32_t of_a, std::uint32_t of_b) { return attributes.difference(of_a, of_b); });
  Correspondence found;
  if (all_match(a, b, matches)) found.order = order_of(a, b, matches);
  found.whole = !found.order.empty();
  found.reordered = found.whole;
  if (!found.whole) drop_far_matches(a, b, matches);
  for (std::size_t f = 0; f < matches.size(); ++f) {
    if (matches[f].face == kNoFace) continue;
    if (f < b.real_faces) ++found.faces;
    if (f >= b.real_faces && b.real_faces > 0) continue;  // vertices without a face do not count
    for (std::size_t k = 0; k < 3; ++k)
      found.pairs.push_back({.a = a.vertices[3 * std::size_t{matches[f].face} + (k + matches[f].turn) % 3],
                             .b = b.vertices[3 * f + k]});
  }
  std::sort(found.pairs.begin(), found.pairs.end());
  found.pairs.erase(std::unique(found.pairs.begin(), found.pairs.end()), found.pairs.end());
  return found;
}

Correspondence correspondence_of(const MeshView& a, const MeshView& b, std::span<const std::uint32_t> order,
                                 const AttributeComparer& attributes) {
  if (!order.empty() || b.vertex_count() == 0) return by_order(a, b, order);
  if (a.vertex_count() == b.vertex_count()) {
    std::vector<std::uint32_t> identity(b.vertex_count());
    std::iota(identity.begin(), identity.end(), 0U);
    Correspondence found = by_order(a, b, identity);
    if (found.whole) return found;
  }
  return by_faces(a, b, attributes);
}

}  // namespace

Result<Comparison> compare(const MeshView& a, const MeshView& b,
                           std::span<const std::uint32_t> order) noexcept try {
  DELTAMESH_CHECK(check_surface(a));
  DELTAMESH_CHECK(check_surface(b));
  DELTAMESH_CHECK(check_attributes(a));
  DELTAMESH_CHECK(check_attributes(b));
  if (!order.empty()) DELTAMESH_CHECK(check_order(order, a.vertex_count(), b.vertex_count()));
  const AttributeComparer attributes(a, b);
  const Correspondence found = correspondence_of(a, b, order, attributes);
  Comparison result;
  result.signed_error.resize(b.vertex_count());
  result.corresponding = found.whole;
  result.reordered = found.reordered;
  result.matched_faces = found.faces;
  result.unmatched_faces_a = a.triangle_count() - found.faces;
  result.unmatched_faces_b = b.triangle_count() - found.faces;
  result.attributes = attributes.compare(found.pairs);
  if (result.corresponding)
    compare_vertices(a, b, found.order, result);
  else
    DELTAMESH_CHECK(compare_surfaces(a, b, result));
  return result;
} catch (const std::bad_alloc&) {
  return Error{.code = ErrorCode::kOutOfMemory, .message = "out of memory while comparing"};
}

}  // namespace deltamesh
