// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "predictive/voxel_edges.h"

namespace deltamesh {

std::optional<VoxelGrid::Cut> VoxelGrid::cut_of(const Cell& cell) const noexcept {
  Cut result{};
  unsigned free_axes = 0;
  std::size_t free_axis = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int32_t node = cell[axis] / voxel_;
    const std::int32_t rest = cell[axis] % voxel_;
    result.vertex.place[axis] = 2 * node + (rest != 0 ? 1 : 0);
    if (rest == 0) continue;
    if (rest % 2 == 0) return std::nullopt;
    ++free_axes;
    free_axis = axis;
    result.level = rest / 2;
  }
  if (free_axes != 1) return std::nullopt;
  cut(result.vertex, free_axis, result.level);
  return result;
}

}  // namespace deltamesh
