// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Adaptive models of the coders of positions.
#pragma once

#include <cstdint>
#include <optional>

#include "positions/grid/models.h"
#include "positions/lattice/coder.h"

namespace deltamesh {

/// Empty of what was not used.
struct PositionModels {
  std::optional<VoxelModels> voxels;
  std::optional<LatticeModels> lattice;

  const VoxelModels* of_voxels() const noexcept { return voxels ? &*voxels : nullptr; }
  const LatticeModels* of_lattice() const noexcept { return lattice ? &*lattice : nullptr; }

  void limit_counts(std::uint8_t most) noexcept {
    if (voxels) voxels->limit_counts(most);
    if (lattice) lattice->limit_counts(most);
  }
};

}  // namespace deltamesh
