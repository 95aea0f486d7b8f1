// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The surface order [ATTR-30] of the vertices: each comes with the faces that it is the last corner of, chart
// after chart. Attributes that are predicted from faces are coded in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/memory/large_vector.h"
#include "topology/vertex_corners.h"

namespace deltamesh {

struct SurfaceOrder {
  LargeVector<std::uint32_t> vertices;  ///< n: each once
  LargeVector<std::uint32_t> ends;      ///< n: how many of `complete` belong to vertices[0 .. i]
  LargeVector<Corner> complete;         ///< m: of each face the corner that comes last

  /// The corners at vertices[i] of the faces whose last corner it is.
  std::span<const Corner> completed_by(std::size_t i) const noexcept {
    const std::uint32_t begin = i == 0 ? 0 : ends[i - 1];
    return {complete.data() + begin, complete.data() + ends[i]};
  }

  /// Visits the other two corners of these faces; all of them come before vertices[i].
  template <class Visit>
  void for_corners_before(std::size_t i, Visit visit) const {
    for (const Corner& corner : completed_by(i)) {
      visit(corner.next);
      visit(corner.before);
    }
  }
};

/// `corners`: those of `triangles`. O(n + m).
SurfaceOrder make_surface_order(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count,
                                const VertexCorners& corners);

}  // namespace deltamesh
