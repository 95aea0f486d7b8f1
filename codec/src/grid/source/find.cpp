// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <vector>

#include "deltamesh/find_grid.h"
#include "grid/source/fit.h"
#include "positions/lattice/axis_values.h"

namespace deltamesh {
namespace {

constexpr std::size_t kSampledVertices = 1U << 15;
constexpr double kMostFaces = 0.5;
constexpr double kHeights = 0.995;  ///< of the edges along one axis: heights over a grid, or a floor

}  // namespace

std::optional<VoxelGrid> find_grid(const MeshView& mesh) {
  const std::vector<Vec3> points = widen_rows(mesh.positions);
  const AxisValues values(points, kSampledVertices);
  const auto found = fit_voxels(values, Box::around(points));
  if (!found || found->along_one_axis > kHeights) return std::nullopt;
  const VoxelFit fit = for_most_faces(*found, values, mesh.triangles);
  if (fit.in_cubes <= kMostFaces) return std::nullopt;
  return VoxelGrid{fit.origin, fit.voxel};
}

bool is_on_grid(const VoxelGrid& grid, const MeshView& mesh) {
  const std::vector<Vec3> points = widen_rows(mesh.positions);
  const AxisValues values(points, kSampledVertices);
  return fit_to_grid(grid, values, Box::around(points)).has_value();
}

}  // namespace deltamesh
