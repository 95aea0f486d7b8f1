// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// An order of the vertices in which each comes with the faces that it is the last corner of, chart after
// chart: what attributes that are predicted from faces are coded in [ATTR-30].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "attributes/vertex_corners.h"
#include "base/large_vector.h"

namespace deltamesh {

struct SurfaceWalk {
  LargeVector<std::uint32_t> order;  ///< n: the vertices, each once
  LargeVector<std::uint32_t> ends;   ///< n: how many of `complete` belong to order[0 .. i]
  LargeVector<Corner> complete;      ///< m: of each face the corner that comes last

  /// Of the faces that order[i] is the last corner of.
  std::span<const Corner> completed_by(std::size_t i) const noexcept {
    const std::uint32_t begin = i == 0 ? 0 : ends[i - 1];
    return {complete.data() + begin, complete.data() + ends[i]};
  }

  /// Of these faces the other corners, all of which come before.
  template <class Visit>
  void for_corners_before(std::size_t i, Visit visit) const {
    for (const Corner& corner : completed_by(i)) {
      visit(corner.next);
      visit(corner.before);
    }
  }
};

/// `corners`: those of `triangles`. O(n + m).
SurfaceWalk walk_surface(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count,
                         const VertexCorners& corners);

}  // namespace deltamesh
