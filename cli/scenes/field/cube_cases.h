// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The 256 ways in which a surface can cut a cube whose corners are inside or outside.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace deltamesh::scenes {

/// Corner c of the unit cube is at (c & 1, c >> 1 & 1, c >> 2 & 1). The four edges along `axis` are numbered
/// 4 axis .. 4 axis + 3 by their low corner.
struct CubeEdge {
  std::uint8_t axis = 0;
  std::uint8_t low = 0;  ///< corner with bit `axis` clear; the other end has it set
};
const std::array<CubeEdge, 12>& cube_edges() noexcept;

/// Three cube edges: a corner of the triangle lies on each. Counter-clockwise seen from outside.
using CubeTriangle = std::array<std::uint8_t, 3>;

/// By a mask of the corners that are inside. On a face with inside corners at both ends of a diagonal only,
/// these are cut off each on its own; since that is decided by the face alone, neighbouring cubes agree and
/// the surface has no cracks. No diagonal of a polygon lies in a face of the cube, so that no edge gets more
/// than two triangles.
const std::array<std::vector<CubeTriangle>, 256>& cube_cases();

}  // namespace deltamesh::scenes
