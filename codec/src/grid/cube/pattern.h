// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What the faces of one cube are: triangles over its edges and a vertex inside it [GRD-5].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "grid/cube/cube.h"

namespace deltamesh::grid {

/// Edges, or kInside, at the corners of a face.
using Triangle = std::array<std::uint8_t, 3>;

/// `triangle`, beginning with its least corner, and how many corners that is turned by.
struct TurnedTriangle {
  Triangle corners;
  std::uint8_t turn;
};
constexpr TurnedTriangle with_least_first(const Triangle& t) noexcept {
  std::uint8_t turn = 0;
  if (t[1] < t[0]) turn = 1;
  if (t[2] < t[turn]) turn = 2;
  return {{t[turn], t[(turn + 1) % 3], t[(turn + 2) % 3]}, turn};
}

/// Twice the coordinates in a cube of its edges' middles, and at kInside of its own.
inline constexpr std::array<Node, kEdges + 1> kMiddles = [] {
  std::array<Node, kEdges + 1> middles{};
  for (unsigned edge = 0; edge < kEdges; ++edge) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      middles[edge][axis] = 2 * static_cast<std::int32_t>(first_corner(edge) >> axis & 1);
    middles[edge][edge / 4] = 1;
  }
  middles[kInside] = {1, 1, 1};
  return middles;
}();

/// Where a face looks to whose corners are in these middles.
inline Node normal_of(const Triangle& triangle) noexcept {
  const Node& a = kMiddles[triangle[0]];
  const Node& b = kMiddles[triangle[1]];
  const Node& c = kMiddles[triangle[2]];
  const auto component = [&](std::size_t i, std::size_t j) {
    return (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
  };
  return {component(1, 2), component(2, 0), component(0, 1)};
}

class Pattern {
 public:
  static constexpr unsigned kMostTriangles = 15;

  std::span<const Triangle> triangles() const noexcept { return std::span(triangles_).first(count_); }
  /// A bit for every edge with a vertex; bit kInside for a vertex inside.
  unsigned used() const noexcept { return used_; }
  bool has_inner() const noexcept { return (used_ >> kInside & 1) != 0; }

  /// Precondition: fewer than kMostTriangles.
  void add(const Triangle& triangle) noexcept {
    triangles_[count_++] = with_least_first(triangle).corners;
    for (const unsigned edge : triangle) used_ = static_cast<std::uint16_t>(used_ | 1U << edge);
  }
  /// Their order, which is that of the mesh's faces.
  void sort() noexcept { std::sort(triangles_.begin(), triangles_.begin() + count_); }

  bool operator==(const Pattern&) const = default;

 private:
  std::array<Triangle, kMostTriangles> triangles_{};
  std::uint8_t count_ = 0;
  std::uint16_t used_ = 0;
};

/// With its edges one after the other.
struct ListedPattern {
  static constexpr unsigned kUsual = 4;

  ListedPattern() = default;
  explicit ListedPattern(const Pattern& listed) noexcept : pattern(listed) {
    for (unsigned edge = 0; edge < kEdges; ++edge)
      if ((listed.used() >> edge & 1) != 0) edges[edge_count++] = static_cast<std::uint8_t>(edge);
    for (unsigned i = std::max(edge_count, 1U); i < kUsual; ++i) edges[i] = edges[i - 1];
  }

  Pattern pattern;
  std::array<std::uint8_t, kEdges> edges{};  ///< ascending; to the number kUsual the last is repeated
  unsigned edge_count = 0;
};

}  // namespace deltamesh::grid
