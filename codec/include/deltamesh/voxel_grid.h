// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The grid that a mesh was cut from, as marching cubes does it.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace deltamesh {

/// Cubes whose corners, the nodes, are `origin` plus whole edges on every axis.
struct VoxelGrid {
  std::array<double, 3> origin{};  ///< a node, relative to the mesh's origin, model units
  std::array<double, 3> edge{};    ///< of the cubes, model units

  bool operator==(const VoxelGrid&) const = default;
};

/// Whether all numbers are finite, and edges above 0.
inline bool is_valid(const VoxelGrid& grid) noexcept {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!std::isfinite(grid.origin[axis]) || !std::isfinite(grid.edge[axis]) || !(grid.edge[axis] > 0))
      return false;
  return true;
}

}  // namespace deltamesh
