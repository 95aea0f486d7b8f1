// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "positions/grid/edges.h"

namespace deltamesh {

std::optional<VoxelGrid::Cut> VoxelGrid::cut_of(const Cell& cell) const noexcept {
  Cut cut{};
  unsigned free_axes = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int32_t rest = cell[axis] % voxel_;
    cut.node[axis] = cell[axis] / voxel_;
    if (rest == 0) continue;
    if (rest % 2 == 0) return std::nullopt;
    ++free_axes;
    cut.axis = axis;
    cut.level = rest / 2;
  }
  if (free_axes != 1) return std::nullopt;
  return cut;
}

}  // namespace deltamesh
