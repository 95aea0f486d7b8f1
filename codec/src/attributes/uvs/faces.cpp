// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/uvs/faces.h"

#include <algorithm>
#include <cmath>

#include "base/numbers/vec3.h"

namespace deltamesh {
namespace {

constexpr std::size_t kAtATime = 64;     ///< faces, about
constexpr double kFarthestCorner = 1e6;  ///< squared distance of a corner from another, in edges
constexpr double kFlattest = 0.05;       ///< height of a face that tells of its neighbour, in edges

/// The place of a corner: edge * x + height * y.
struct Apex {
  double x = 0;
  double y = 0;
  bool is_near = false;  ///< else it is out of all proportion
};

}  // namespace

struct UvFaces::Edge {
  Edge(const Vec3& a, const Vec3& b) noexcept : origin(a), way(b - a), inverse(1 / dot(way, way)) {}

  Apex place(const Vec3& corner) const noexcept {
    const Vec3 from = corner - origin;
    Apex apex;
    apex.x = dot(way, from) * inverse;
    const double distance = dot(from, from) * inverse;
    apex.y = std::sqrt(std::max(distance - apex.x * apex.x, 0.0));
    apex.is_near = distance <= kFarthestCorner;
    return apex;
  }

  Vec3 origin;
  Vec3 way;
  double inverse;  ///< 1 / its squared length
};

UvFaces::UvFaces(const AttributeSurface& surface, const SurfaceOrder& order)
    : surface_(surface), order_(order), corners_(surface.corners()), places_(surface.vertex_count()) {
  for (std::uint32_t i = 0; i < order.vertices.size(); ++i) places_[order.vertices[i]] = i;
}

void UvFaces::make(std::size_t i) {
  faces_.clear();
  first_face_ = i == 0 ? 0 : order_.ends[i - 1];
  for (end_ = i; end_ < order_.vertices.size() && (end_ == i || faces_.size() < kAtATime); ++end_)
    for (const Corner& corner : order_.completed_by(end_)) add(end_, corner);
}

/// Of the first other face with the edge, if its corner is known. Looked for at the end of the edge with
/// fewer faces, as all edges of a fan have its hub at one end.
std::uint32_t UvFaces::find_across(std::size_t i, const Corner& corner) const noexcept {
  const auto at_a = corners_.of(corner.next);
  const auto at_b = corners_.of(corner.before);
  if (at_a.size() <= at_b.size()) {
    for (const Corner& other : at_a)
      if (other.before == corner.before && other.face != corner.face && is_before(other.next, i))
        return other.next;
  } else {
    for (const Corner& other : at_b)
      if (other.next == corner.next && other.face != corner.face && is_before(other.before, i))
        return other.before;
  }
  return kNoUvVertex;
}

void UvFaces::add(std::size_t i, const Corner& corner) {
  UvFace face{};
  face.a = corner.next;
  face.b = corner.before;
  face.across = find_across(i, corner);
  if (surface_.has_positions()) {
    const Edge edge(surface_.position(face.a), surface_.position(face.b));
    const Apex apex = edge.place(surface_.position(order_.vertices[i]));
    face.counts = apex.is_near;
    face.x = apex.x;
    face.y = apex.y;
    face.weight = 1 / (apex.y + 0.01);
    if (face.across != kNoUvVertex) {
      const Apex across = edge.place(surface_.position(face.across));
      face.goes_on = across.is_near;
      face.across_x = across.x;
      face.ratio = apex.y / across.y;
      const double reach = std::min(face.ratio, 4.0);
      const double weight = face.weight / (1 + reach * reach);
      face.across_weight = across.is_near && across.y > kFlattest ? weight : 0;
    }
  }
  faces_.push_back(face);
}

}  // namespace deltamesh
