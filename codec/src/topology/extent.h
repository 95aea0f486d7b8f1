// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Where a mesh is: the box of its vertices without the few that lie far away, as of a sensor's failed
// reading.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/numbers/vec3.h"

namespace deltamesh {

struct Extent {
  double diagonal = 0;  ///< of the box of all vertices but the strays
  std::uint64_t strays = 0;
  Box reach = Box::empty();  ///< strays are outside; of no meaning without strays

  bool is_stray(const Vec3& p) const noexcept {
    bool inside = true;
    for (std::size_t k = 0; k < 3; ++k) inside = inside && p[k] >= reach.min[k] && p[k] <= reach.max[k];
    return strays > 0 && !inside;
  }
};

/// Strays: at most one in 100 vertices, farther than its longest side from the box that has all but a
/// thousandth of the vertices at either end of every axis. Without strays the diagonal is that of `box`, the
/// box of all. O(n).
Extent extent_of(std::span<const Vec3> positions, const Box& box);

}  // namespace deltamesh
