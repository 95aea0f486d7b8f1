// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Finds the voxel grid that a mesh was cut from, by the planes on which coordinates pile up. Encoder only.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/numbers/vec3.h"
#include "deltamesh/voxel_grid.h"
#include "format/predictive_parameters.h"
#include "positions/blend/blend.h"
#include "positions/lattice/axis_values.h"

namespace deltamesh {

struct VoxelFit {
  Vec3 origin{};              ///< a node at or below the smallest coordinate
  Vec3 voxel{};               ///< edge lengths, model units
  double noise = 0;           ///< how far from a plane a coordinate on it may be
  double share = 0;           ///< of the vertices on an edge
  double in_cubes = 0;        ///< share of the faces that lie in a cube, their corners on its edges
  double along_one_axis = 0;  ///< share of these edges along the axis that most have
  bool is_given = false;      ///< `origin` stays that of the lattice, wherever the mesh is
};

/// Empty where fewer than a fifth of the sampled vertices are on the edges of one grid. O(n).
std::optional<VoxelFit> fit_voxels(const AxisValues& values, const Box& box);

/// `grid` as the fit of the mesh; empty as above. O(n).
std::optional<VoxelFit> fit_to_grid(const VoxelGrid& grid, const AxisValues& values, const Box& box);

/// `fit` with its share of faces, or, unless it is given, the same with cubes of twice the size, in whichever
/// more faces lie: an octree's are of several sizes, and planes on which coordinates pile up are those of the
/// smallest. `triangles`: m x 3, of which some are looked at. O(n).
VoxelFit for_most_faces(const VoxelFit& fit, const AxisValues& values,
                        std::span<const std::uint32_t> triangles);

/// The fine lattice of `fit` with this many levels per edge, and the vertices on it. Empty where it would
/// exceed kMostCells.
struct VoxelCells {
  PositionLattice lattice;
  std::vector<Cell> cells;
};
std::optional<VoxelCells> to_voxel_cells(std::span<const Vec3> positions, const Box& box, const VoxelFit& fit,
                                         std::uint32_t levels);

}  // namespace deltamesh
