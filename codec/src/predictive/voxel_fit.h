// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Finds the voxel grid that a mesh was cut from, by the planes on which coordinates pile up. Encoder only.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "format/predictive_parameters.h"
#include "predictive/axis_values.h"
#include "predictive/blend.h"

namespace deltamesh {

struct VoxelFit {
  Vec3 origin{};     ///< a node at or below the smallest coordinate
  Vec3 voxel{};      ///< edge lengths, model units
  double noise = 0;  ///< how far from a plane a coordinate on it may be
  double share = 0;  ///< of the vertices on an edge
};

/// Empty where fewer than a fifth of the sampled vertices are on the edges of one grid. O(n).
std::optional<VoxelFit> fit_voxels(const AxisValues& values, const Box& box);

/// An axis whose coordinates are all whole steps from `origin`, but for rounding.
struct AxisGrid {
  double origin = 0;
  double step = 0;  ///< 0 where there is none
};
/// What quantised sources and heights over a grid have: all vertices, not only those of the sample. `finest`:
/// a smaller step is not looked for. O(n).
std::array<AxisGrid, 3> fit_axes(const AxisValues& values, const Box& box, double finest = 0);

/// cubic_lattice(), but with the own steps of axes that have a grid not much finer.
PositionLattice grid_lattice(const Box& box, const std::array<AxisGrid, 3>& axes, double step) noexcept;

/// The fine lattice of `fit` with this many levels per edge, and the vertices on it. Empty where it would
/// exceed kMostCells.
struct VoxelCells {
  PositionLattice lattice;
  std::vector<Cell> cells;
};
std::optional<VoxelCells> to_voxel_cells(std::span<const Vec3> positions, const Box& box, const VoxelFit& fit,
                                         std::uint32_t levels);

}  // namespace deltamesh
