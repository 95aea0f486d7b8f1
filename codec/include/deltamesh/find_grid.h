// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Finds out whether a mesh was cut from a grid.
#pragma once

#include <optional>

#include "deltamesh/mesh.h"
#include "deltamesh/voxel_grid.h"

namespace deltamesh {

/// The grid in whose cubes most faces of the mesh lie, relative to its origin. Empty where there is none, and
/// for heights over a grid: where next to no vertex is on edges of a second axis. Looks at some 30,000
/// vertices. Precondition: finite positions, and indices in range. O(n).
std::optional<VoxelGrid> find_grid(const MeshView& mesh);

/// Whether a fair share of the vertices, one in five, is on the grid's edges. Looks at as many.
/// Preconditions: is_valid(), and that of find_grid(). O(n).
bool is_on_grid(const VoxelGrid& grid, const MeshView& mesh);

}  // namespace deltamesh
