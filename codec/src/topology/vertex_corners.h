// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The corners of faces by vertex.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/memory/large_vector.h"

namespace deltamesh {

/// A corner of a face, as its vertex sees it.
struct Corner {
  std::uint32_t face;
  std::uint32_t next;    ///< vertex at the corner after it, in the face's order
  std::uint32_t before;  ///< at the one before it
};

class VertexCorners {
 public:
  /// `triangles`: m x 3 indices below `vertex_count`. O(n + m).
  VertexCorners(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count)
      : offsets_(std::size_t{vertex_count} + 2, 0), corners_(triangles.size()) {
    // Counts go two places up, so that offsets_[v + 1] is where the next corner of v belongs, and its end
    // after.
    for (const std::uint32_t v : triangles) ++offsets_[v + std::size_t{2}];
    for (std::size_t v = 2; v < offsets_.size(); ++v) offsets_[v] += offsets_[v - 1];
    for (std::uint32_t face = 0; face < triangles.size() / 3; ++face) {
      const std::uint32_t* const v = triangles.data() + std::size_t{3} * face;
      const auto add = [&](std::uint32_t vertex, std::uint32_t next, std::uint32_t before) {
        corners_[offsets_[vertex + std::size_t{1}]++] = {face, next, before};
      };
      add(v[0], v[1], v[2]);
      add(v[1], v[2], v[0]);
      add(v[2], v[0], v[1]);
    }
  }

  /// In the order of the faces.
  std::span<const Corner> of(std::uint32_t vertex) const noexcept {
    return {corners_.data() + offsets_[vertex], corners_.data() + offsets_[vertex + std::size_t{1}]};
  }

 private:
  LargeVector<std::uint32_t> offsets_;  ///< n + 2
  LargeVector<Corner> corners_;
};

}  // namespace deltamesh
