// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "field/cube_cases.h"

#include <span>

namespace deltamesh::scenes {
namespace {

constexpr std::uint8_t kNone = 255;

constexpr std::array<CubeEdge, 12> list_edges() {
  std::array<CubeEdge, 12> edges{};
  std::size_t next = 0;
  for (std::uint8_t axis = 0; axis < 3; ++axis)
    for (std::uint8_t corner = 0; corner < 8; ++corner)
      if ((corner >> axis & 1) == 0) edges[next++] = {axis, corner};
  return edges;
}

constexpr std::array<CubeEdge, 12> kEdges = list_edges();

std::uint8_t edge_between(unsigned a, unsigned b) {
  const unsigned low = a & b;
  for (std::uint8_t e = 0; e < 12; ++e)
    if (kEdges[e].low == low && (1U << kEdges[e].axis) == (a ^ b)) return e;
  return kNone;
}

/// The corners of a face, counter-clockwise seen from outside the cube.
std::array<unsigned, 4> face_corners(unsigned axis, bool high) {
  const unsigned u = 1U << (axis + 1) % 3;
  const unsigned v = 1U << (axis + 2) % 3;
  if (high) return {1U << axis, 1U << axis | u, 1U << axis | u | v, 1U << axis | v};
  return {0, v, u | v, u};
}

bool share_face(std::uint8_t a, std::uint8_t b) {
  for (unsigned axis = 0; axis < 3; ++axis) {
    if (kEdges[a].axis == axis || kEdges[b].axis == axis) continue;
    if ((kEdges[a].low >> axis & 1) == (kEdges[b].low >> axis & 1)) return true;
  }
  return false;
}

/// For every cut edge the next one around its polygon. Every face contributes, for each run of inside corners
/// on its outline, a segment from the edge where the run begins to the one where it ends. A cut edge is
/// walked in opposite directions on its two faces, so it begins a run on one and ends one on the other: the
/// segments form cycles.
std::array<std::uint8_t, 12> next_edges(unsigned inside) {
  std::array<std::uint8_t, 12> next;
  next.fill(kNone);
  for (unsigned face = 0; face < 6; ++face) {
    const auto corners = face_corners(face / 2, face % 2 == 1);
    for (unsigned k = 0; k < 4; ++k) {
      const auto is_inside = [&](unsigned i) { return (inside >> corners[i % 4] & 1) != 0; };
      if (is_inside(k) || !is_inside(k + 1)) continue;
      unsigned last = k + 1;
      while (is_inside(last + 1)) ++last;
      next[edge_between(corners[k], corners[(k + 1) % 4])] =
          edge_between(corners[last % 4], corners[(last + 1) % 4]);
    }
  }
  return next;
}

/// Cuts a polygon of at most 12 corners into triangles whose new edges share no cube face. Depth of
/// recursion: below
/// 12. False where there is no such cut.
bool triangulate(std::span<const std::uint8_t> polygon, std::vector<CubeTriangle>& triangles) {
  if (polygon.size() < 3) return true;
  const std::size_t last = polygon.size() - 1;
  for (std::size_t apex = 1; apex < last; ++apex) {
    const bool left_fits = apex == 1 || !share_face(polygon[0], polygon[apex]);
    const bool right_fits = apex + 1 == last || !share_face(polygon[apex], polygon[last]);
    if (!left_fits || !right_fits) continue;
    const std::size_t before = triangles.size();
    triangles.push_back({polygon[0], polygon[apex], polygon[last]});
    if (triangulate(polygon.first(apex + 1), triangles) && triangulate(polygon.subspan(apex), triangles))
      return true;
    triangles.resize(before);
  }
  return false;
}

std::vector<CubeTriangle> make_case(unsigned inside) {
  std::array<std::uint8_t, 12> next = next_edges(inside);
  std::vector<CubeTriangle> triangles;
  for (std::uint8_t start = 0; start < 12; ++start) {
    std::vector<std::uint8_t> polygon;
    for (std::uint8_t e = start; next[e] != kNone;) {
      polygon.push_back(e);
      const std::uint8_t following = next[e];
      next[e] = kNone;
      e = following;
    }
    triangulate(polygon, triangles);
  }
  return triangles;
}

std::array<std::vector<CubeTriangle>, 256> make_cases() {
  std::array<std::vector<CubeTriangle>, 256> cases;
  for (unsigned inside = 0; inside < 256; ++inside) cases[inside] = make_case(inside);
  return cases;
}

}  // namespace

const std::array<CubeEdge, 12>& cube_edges() noexcept { return kEdges; }

const std::array<std::vector<CubeTriangle>, 256>& cube_cases() {
  static const auto cases = make_cases();
  return cases;
}

}  // namespace deltamesh::scenes
