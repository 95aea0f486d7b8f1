// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The corners of faces by vertex. Corner 3 f + k is corner k of face f.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/large_vector.h"

namespace deltamesh {

class VertexCorners {
 public:
  /// `triangles`: m x 3 indices below `vertex_count`. O(n + m).
  VertexCorners(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count)
      : offsets_(std::size_t{vertex_count} + 2, 0), corners_(triangles.size()) {
    // Counts go two places up, so that offsets_[v + 1] is where the next corner of v belongs, and its end
    // after.
    for (const std::uint32_t v : triangles) ++offsets_[v + std::size_t{2}];
    for (std::size_t v = 2; v < offsets_.size(); ++v) offsets_[v] += offsets_[v - 1];
    for (std::uint32_t c = 0; c < triangles.size(); ++c)
      corners_[offsets_[triangles[c] + std::size_t{1}]++] = c;
  }

  /// Ascending.
  std::span<const std::uint32_t> of(std::uint32_t vertex) const noexcept {
    return {corners_.data() + offsets_[vertex], corners_.data() + offsets_[vertex + std::size_t{1}]};
  }

 private:
  LargeVector<std::uint32_t> offsets_;  ///< n + 2
  LargeVector<std::uint32_t> corners_;
};

/// The other two corners of a corner's face, in the face's order.
constexpr std::uint32_t next_corner(std::uint32_t corner) noexcept {
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}
constexpr std::uint32_t corner_before(std::uint32_t corner) noexcept {
  return corner % 3 == 0 ? corner + 2 : corner - 1;
}

}  // namespace deltamesh
