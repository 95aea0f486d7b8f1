// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a grid may hold [GRD-1, GRD-8].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "format/predictive_parameters.h"
#include "grid/surface.h"

namespace deltamesh::grid {

/// How many bricks a mesh of `vertices` may have. A brick takes some 11 kB. Maps have 150 vertices or more in
/// each, tenfold what is asked here.
inline std::uint32_t most_bricks(std::size_t vertices) noexcept {
  return static_cast<std::uint32_t>(std::min<std::size_t>(kMostBricks, 64 + vertices / 16));
}

/// `known`: vertices of the mesh that readers know.
inline Limits limits_of(const PredictiveParameters& parameters, std::uint32_t vertices,
                        std::uint32_t triangles, std::size_t known = 0) noexcept {
  Limits limits{.vertices = vertices, .triangles = triangles, .voxel = 2 * parameters.levels};
  // Of all cubes with a corner that is a node of the lattice.
  for (std::size_t axis = 0; axis < 3; ++axis)
    limits.bricks[axis] = (parameters.lattice.cells[axis] / limits.voxel + kSide + 1) / kSide;
  limits.most_bricks = most_bricks(vertices + known);
  return limits;
}

/// Whether bricks can be numbered.
inline bool are_few(const std::array<std::uint32_t, 3>& bricks) noexcept {
  return std::uint64_t{bricks[0]} * bricks[1] < (std::uint64_t{1} << 32) / bricks[2];
}

}  // namespace deltamesh::grid
