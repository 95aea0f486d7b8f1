// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The corners of faces by geometric vertex.
#pragma once

#include <cstdint>
#include <span>

#include "attributes/attribute_surface.h"
#include "base/large_vector.h"

namespace deltamesh {

/// Corner c is that of face c / 3; ascending for each geometric vertex.
class CornersByVertex {
 public:
  /// Geometric vertices must be numbered from 0 on without gaps, and never fall from vertex to vertex. O(n +
  /// m).
  explicit CornersByVertex(const AttributeSurface& surface)
      : vertices_(first_vertices(surface)),
        offsets_(vertices_.size() + 1),
        corners_(surface.triangles().size()) {
    const auto triangles = surface.triangles();
    offsets_.assign(offsets_.size(), 0);
    // Counts go two places up, so that offsets_[g + 1] is where the next corner of g belongs, and its end
    // after.
    for (const std::uint32_t v : triangles) ++offsets_[surface.geometric_of(v) + std::size_t{2}];
    for (std::size_t g = 2; g < offsets_.size(); ++g) offsets_[g] += offsets_[g - 1];
    for (std::uint32_t c = 0; c < triangles.size(); ++c)
      corners_[offsets_[surface.geometric_of(triangles[c]) + std::size_t{1}]++] = c;
  }

  std::uint32_t geometric_count() const noexcept { return static_cast<std::uint32_t>(vertices_.size() - 1); }
  /// Its copies are the vertices from this one up to the first of the next.
  std::uint32_t first_vertex(std::uint32_t geometric) const noexcept { return vertices_[geometric]; }
  std::span<const std::uint32_t> of(std::uint32_t geometric) const noexcept {
    return {corners_.data() + offsets_[geometric], corners_.data() + offsets_[geometric + 1]};
  }

 private:
  static LargeVector<std::uint32_t> first_vertices(const AttributeSurface& surface) {
    LargeVector<std::uint32_t> first;
    const std::uint32_t count = surface.vertex_count();
    first.reserve(count + std::size_t{1});
    for (std::uint32_t v = 0; v < count; ++v)
      if (v == 0 || surface.geometric_of(v) != surface.geometric_of(v - 1)) first.push_back(v);
    first.push_back(count);
    return first;
  }

  LargeVector<std::uint32_t> vertices_;  ///< geometric vertices + 1
  LargeVector<std::uint32_t> offsets_;   ///< geometric vertices + 2
  LargeVector<std::uint32_t> corners_;
};

}  // namespace deltamesh
