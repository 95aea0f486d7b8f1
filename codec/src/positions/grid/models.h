// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Adaptive models of the coder of voxel edges [VOX-*].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "entropy/coder/model.h"
#include "entropy/coder/number_model.h"
#include "positions/grid/level_coder.h"
#include "positions/grid/view.h"
#include "positions/residual_coder.h"

namespace deltamesh {

/// Models are created when a set of likely edges first occurs, as few of the possible sets do.
class VoxelEdgeModels {
 public:
  VoxelEdgeModels() : places_(voxel::kPairKinds << voxel::kEdges) {}

  /// The model for these; valid until the next call. `likely`: a bit for each edge.
  [[gnu::always_inline]] SymbolModel& of(unsigned kind, unsigned likely, unsigned opposite) {
    std::uint16_t& place = places_[kind << voxel::kEdges | likely];
    if (place == 0) [[unlikely]]
      place = add(likely);
    return models_[std::size_t{place} * kOpposites - kOpposites + opposite];
  }

  void limit_counts(std::uint8_t most) noexcept {
    for (SymbolModel& model : models_) model.limit_count(most);
  }

 private:
  static constexpr std::size_t kOpposites = VoxelPair::kOpen + 1;

  /// For a set that was not met before: where its models are, from 1.
  [[gnu::noinline]] std::uint16_t add(unsigned likely) {
    std::array<std::uint8_t, kSymbols> weights{};
    for (unsigned i = 0; i < voxel::kEdges; ++i) weights[i] = (likely >> i & 1) != 0 ? 20 : 1;
    weights[voxel::kNoEdge] = 1;
    models_.resize(models_.size() + VoxelPair::kOpen, SymbolModel(weights));
    weights[VoxelPair::kOpen] = 100;
    models_.push_back(SymbolModel(weights));
    return static_cast<std::uint16_t>(models_.size() / kOpposites);
  }

  std::vector<std::uint16_t> places_;  ///< by kind and set of likely edges: of models_, or 0
  std::vector<SymbolModel> models_;    ///< by place from 1, and opposite
};

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
  VoxelLevelModels levels;
  SymbolModel start{kFreshStart};
  std::array<NumberModel, 3> start_nodes;
};

}  // namespace deltamesh
