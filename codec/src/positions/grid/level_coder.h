// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Codes the level of a vertex along its voxel edge [VOX-6].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "entropy/coder/model.h"
#include "positions/grid/view.h"

namespace deltamesh {

struct VoxelLevelModels {
  std::uint32_t levels = 0;  ///< of an edge; 0: made for none
  std::vector<SymbolModel> symbols;
};

/// `Coder` is CompactWriter or CompactReader.
template <class Coder>
class VoxelLevelCoder {
 public:
  /// `levels`: of an edge, 1 or more. `start` counts only if it is of as many.
  VoxelLevelCoder(Coder& coder, std::uint32_t levels, VoxelLevelModels start = {})
      : coder_(coder), levels_(levels), models_(std::move(start)) {
    while ((levels - 1) >> low_bits_ >= kSymbols) ++low_bits_;
    if (models_.levels == levels) return;
    std::array<std::uint8_t, kSymbols> weights{};
    for (std::uint32_t i = 0; i <= (levels - 1) >> low_bits_; ++i) weights[i] = 1;
    models_ = {.levels = levels, .symbols = {}};
    models_.symbols.assign(std::size_t{VoxelPair::kPlaces} * VoxelPair::kPlaces, SymbolModel(weights));
  }

  const VoxelLevelModels& models() const noexcept { return models_; }

  /// A level, which a reader gets; from a bad stream it may be as large as its bits let it.
  /// `mean` and `plane`: places where it is expected.
  [[gnu::always_inline]] std::int32_t code(std::int32_t level, std::int32_t mean, std::int32_t plane) {
    if (levels_ == 1) return 0;
    SymbolModel& model = models_.symbols[static_cast<std::size_t>(mean * VoxelPair::kPlaces + plane)];
    const auto high = static_cast<std::int32_t>(
        coder_.symbol(static_cast<unsigned>(level) >> low_bits_, Mixture<1>{{&model}}));
    if (low_bits_ == 0) return high;
    const std::uint32_t low = static_cast<std::uint32_t>(level) & ((1U << low_bits_) - 1);
    return high << low_bits_ | static_cast<std::int32_t>(coder_.bits(low, low_bits_));
  }

 private:
  Coder& coder_;
  std::uint32_t levels_;
  unsigned low_bits_ = 0;  ///< outside the symbol
  VoxelLevelModels models_;
};

}  // namespace deltamesh
