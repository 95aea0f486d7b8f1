// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "measure/correspondence.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "measure/face_matching.h"

namespace deltamesh {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// A vertex that moved by less than this share of an edge is the same one by more than chance.
constexpr double kCredible = 0.25;

/// The smallest of the three rotations; equal for two triangles exactly when one is a rotation of the other.
Triangle canonical(const Triangle& t) {
  return std::min({t, Triangle{t[1], t[2], t[0]}, Triangle{t[2], t[0], t[1]}});
}

template <class Map>
std::vector<Triangle> sorted_triangles(std::span<const std::uint32_t> triangles, Map map) {
  std::vector<Triangle> sorted(triangles.size() / 3);
  for (std::size_t i = 0; i < sorted.size(); ++i)
    sorted[i] = canonical({map(triangles[3 * i]), map(triangles[3 * i + 1]), map(triangles[3 * i + 2])});
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

bool all_distinct(std::span<const std::uint32_t> order, std::size_t bound) {
  std::vector<bool> seen(bound);
  for (const std::uint32_t v : order) {
    if (seen[v]) return false;
    seen[v] = true;
  }
  return true;
}

/// Whether the triangles of `b`, their indices mapped by `order`, are exactly those of `a`: the same
/// orientation, any rotation within a triangle, any sequence of triangles, each as often. `order`: one vertex
/// of `a` for every vertex of `b`, every index below `a_vertices`; each at most once, or the answer is no.
/// Cost O(m log m).
bool triangles_correspond(std::span<const std::uint32_t> a, std::size_t a_vertices,
                          std::span<const std::uint32_t> b, std::span<const std::uint32_t> order) {
  if (a.size() != b.size() || !all_distinct(order, a_vertices)) return false;
  return sorted_triangles(a, [](std::uint32_t v) { return v; }) ==
         sorted_triangles(b, [order](std::uint32_t v) { return order[v]; });
}

/// Largest distance of a corner of face `f` of `b` from that of its match.
double match_distance(const FaceGraph& a, const FaceGraph& b, std::uint32_t f, const FaceMatch& match) {
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    largest = std::max(largest, length(b.at(f, k) - a.at(match.face, (k + match.rotation) % 3)));
  return largest;
}

/// 0 of none.
double median(std::vector<double>& values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Drops matches whose corners are too far apart to be the same face; all of them where most are. For meshes
/// whose faces do not correspond one to one. O(m).
void drop_far_matches(const FaceGraph& a, const FaceGraph& b, std::vector<FaceMatch>& matches) {
  std::vector<double> distances;
  std::vector<double> edges;
  for (std::uint32_t f = 0; f < b.real_faces; ++f) {
    if (matches[f].face == kNoFace) continue;
    distances.push_back(match_distance(a, b, f, matches[f]));
    edges.push_back(a.longest_edge(matches[f].face));
  }
  const double typical = median(distances);
  const bool credible = typical <= kCredible * median(edges);
  for (std::uint32_t f = 0; f < matches.size(); ++f) {
    FaceMatch& match = matches[f];
    if (match.face == kNoFace) continue;
    const double most = std::max(4 * typical, kCredible * a.longest_edge(match.face));
    if (!credible || match_distance(a, b, f, match) > most) match = {};
  }
}

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

/// As Correspondence::order; empty where a vertex of a face of B is none of A's, or is at several places of
/// A.
std::vector<std::uint32_t> order_of(const FaceGraph& a, const FaceGraph& b,
                                    std::span<const FaceMatch> matches) {
  std::vector<std::uint32_t> welded(b.positions.size(), kUnmatched);
  std::vector<std::uint32_t> order(b.positions.size(), kUnmatched);
  for (std::size_t f = 0; f < matches.size(); ++f) {
    if (matches[f].face == kNoFace) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t corner = 3 * std::size_t{matches[f].face} + (k + matches[f].rotation) % 3;
      const std::uint32_t v = b.vertices[3 * f + k];
      if (welded[v] != kUnmatched && welded[v] != a.corners[corner]) return {};
      welded[v] = a.corners[corner];
      order[v] = a.vertices[corner];
    }
  }
  if (std::find(order.begin(), order.end(), kUnmatched) == order.end()) return order;
  if (b.real_faces == 0) return {};
  // Vertices that no face uses count where each has one in A.
  std::vector<std::uint32_t> of_faces(order.size(), kUnmatched);
  for (const std::uint32_t v : std::span(b.vertices).first(3 * b.real_faces)) {
    if (order[v] == kUnmatched) return {};
    of_faces[v] = order[v];
  }
  return of_faces;
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
      found.pairs.push_back(
          {.a = a.vertices[3 * std::size_t{matches[f].face} + (k + matches[f].rotation) % 3],
           .b = b.vertices[3 * f + k]});
  }
  std::sort(found.pairs.begin(), found.pairs.end());
  found.pairs.erase(std::unique(found.pairs.begin(), found.pairs.end()), found.pairs.end());
  return found;
}

/// Whether faces hardly have vertices in common, so that numbers do not tell which is which.
bool share_no_vertices(const MeshView& mesh) {
  constexpr double kMost = 0.9;  // vertices in use for each corner of a face
  std::vector<bool> used(mesh.vertex_count());
  std::size_t count = 0;
  for (const std::uint32_t v : mesh.triangles) {
    count += used[v] ? 0 : 1;
    used[v] = true;
  }
  return static_cast<double>(count) >= kMost * static_cast<double>(mesh.triangles.size());
}

/// Of the places of two meshes, relative to A's origin.
class Places {
 public:
  Places(const MeshView& a, const MeshView& b) : a_(a), b_(b), apart_(widen(b.origin) - widen(a.origin)) {}

  double apart(const VertexPair& pair) const { return length(at(b_, pair.b) + apart_ - at(a_, pair.a)); }

  /// Whether no vertex is far from that of the same number; of points, whether none is elsewhere.
  bool are_near() const {
    if (a_.triangles.empty()) {
      for (std::uint32_t v = 0; v < a_.vertex_count(); ++v)
        if (apart({.a = v, .b = v}) > 0) return false;
    }
    for (std::size_t c = 0; c + 2 < a_.triangles.size(); c += 3) {
      const std::uint32_t* const t = &a_.triangles[c];
      double longest = 0;
      for (std::size_t k = 0; k < 3; ++k)
        longest = std::max(longest, length(at(a_, t[k]) - at(a_, t[(k + 1) % 3])));
      for (std::size_t k = 0; k < 3; ++k)
        if (apart({.a = t[k], .b = t[k]}) > kCredible * longest) return false;
    }
    return true;
  }

  double mean_square(const std::vector<VertexPair>& pairs) const {
    double sum = 0;
    for (const VertexPair& pair : pairs) sum += apart(pair) * apart(pair);
    return sum / static_cast<double>(std::max<std::size_t>(pairs.size(), 1));
  }

 private:
  static Vec3 at(const MeshView& mesh, std::uint32_t v) noexcept {
    return widen(mesh.positions.subspan(3 * std::size_t{v}, 3));
  }

  const MeshView& a_;
  const MeshView& b_;
  Vec3 apart_;
};

}  // namespace

Correspondence correspondence_of(const MeshView& a, const MeshView& b, std::span<const std::uint32_t> order,
                                 const AttributeComparer& attributes) {
  if (!order.empty() || b.vertex_count() == 0) return by_order(a, b, order);
  if (a.vertex_count() == b.vertex_count()) {
    std::vector<std::uint32_t> identity(b.vertex_count());
    std::iota(identity.begin(), identity.end(), 0U);
    Correspondence found = by_order(a, b, identity);
    const Places places(a, b);
    if (found.whole && (!share_no_vertices(a) || places.are_near())) return found;
    constexpr double kClear = 0.25;
    Correspondence matched = by_faces(a, b, attributes);
    const bool is_clear =
        matched.whole && places.mean_square(matched.pairs) < kClear * places.mean_square(found.pairs);
    return found.whole && !is_clear ? std::move(found) : std::move(matched);
  }
  return by_faces(a, b, attributes);
}

}  // namespace deltamesh
