// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// An order of the vertices in which each comes with the faces that it is the last corner of, chart after
// chart: what attributes that are predicted from faces are coded in [ATTR-30].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/large_vector.h"

namespace deltamesh {

/// Corner 3 f + k is corner k of face f.
struct SurfaceWalk {
  LargeVector<std::uint32_t> order;     ///< n: the vertices, each once
  LargeVector<std::uint32_t> ends;      ///< n: how many of `complete` belong to order[0 .. i]
  LargeVector<std::uint32_t> complete;  ///< m: of each face the corner that comes last
  LargeVector<std::uint32_t> offsets;   ///< n + 1
  LargeVector<std::uint32_t> corners;   ///< 3 m: those of vertex v from offsets[v] to offsets[v + 1]

  /// Of the faces that order[i] is the last corner of.
  std::span<const std::uint32_t> completed_by(std::size_t i) const noexcept {
    const std::uint32_t begin = i == 0 ? 0 : ends[i - 1];
    return {complete.data() + begin, complete.data() + ends[i]};
  }
  std::span<const std::uint32_t> corners_of(std::uint32_t vertex) const noexcept {
    return {corners.data() + offsets[vertex], corners.data() + offsets[vertex + 1]};
  }
};

/// The other two corners of a corner's face, in the face's order.
constexpr std::uint32_t next_corner(std::uint32_t corner) noexcept {
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}
constexpr std::uint32_t corner_before(std::uint32_t corner) noexcept {
  return corner % 3 == 0 ? corner + 2 : corner - 1;
}

/// `triangles`: m x 3 indices below `vertex_count`. O(n + m).
SurfaceWalk walk_surface(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count);

}  // namespace deltamesh
