// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What the coder of voxel edges learns [VOX-*].
#pragma once

#include <array>
#include <cstdint>

#include "entropy/number_model.h"
#include "predictive/residual_coder.h"
#include "predictive/voxel_edge_models.h"
#include "predictive/voxel_level_coder.h"

namespace deltamesh {

struct VoxelModels {
  static constexpr SymbolModel kFreshStart{{8, 8, 8, 8, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}};

  void limit_counts(std::uint8_t most) noexcept {
    residuals.limit_counts(most);
    edges.limit_counts(most);
    for (SymbolModel& model : levels.symbols) model.limit_count(most);
    start.limit_count(most);
    for (NumberModel& model : start_nodes) model.length.limit_count(most);
  }

  ResidualModels residuals;
  VoxelEdgeModels edges;
  MixWeights<1> edge_weights;
  VoxelLevelModels levels;
  SymbolModel start{kFreshStart};
  MixWeights<1> start_weights;
  std::array<NumberModel, 3> start_nodes;
};

}  // namespace deltamesh
