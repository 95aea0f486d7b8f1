// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The difference between a coordinate and its prediction [POSN-6, POSN-7]. One template for both directions.
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "entropy/coder/split_number.h"
#include "entropy/coder/symbol_models.h"
#include "positions/residual_context.h"

namespace deltamesh {

struct ResidualModels {
  std::array<SymbolModels, kResidualModels> symbols{SymbolModels(kResidualContexts[0], kFreshSplit),
                                                    SymbolModels(kResidualContexts[1], kFreshSplit)};
  std::array<MixWeights, kResidualWeightSets> weights;
  SplitNumberModels numbers;

  void limit_counts(std::uint8_t most) noexcept {
    for (SymbolModels& models : symbols) models.limit_counts(most);
    numbers.limit_counts(most);
  }
};

/// `Coder` is CompactWriter or CompactReader.
template <class Coder>
class ResidualCoder {
 public:
  explicit ResidualCoder(Coder& coder, ResidualModels start = {})
      : coder_(coder), numbers_(coder, start.numbers), models_(std::move(start)) {}

  ResidualModels models() const {
    ResidualModels learnt = models_;
    learnt.numbers = numbers_.models();
    return learnt;
  }

  /// A reader's argument is ignored. Where the stream lies the result is anything below 2^62 in size.
  std::int64_t code(std::int64_t residual, const ResidualPrediction& f) { return code(coder_, residual, f); }
  /// `coder`: as SplitNumberCoder has it.
  [[gnu::always_inline]] std::int64_t code(Coder& coder, std::int64_t residual, const ResidualPrediction& f) {
    const Mixture<kResidualModels> mixture{
        {&models_.symbols[0][f.contexts[0]], &models_.symbols[1][f.contexts[1]]},
        &models_.weights[f.weight_set]};
    const std::int64_t result = numbers_.code(coder, (residual ^ f.sign) - f.sign, f.shift, mixture);
    return (result ^ f.sign) - f.sign;
  }

 private:
  Coder& coder_;
  SplitNumberCoder<Coder> numbers_;
  ResidualModels models_;  ///< but for those of numbers_
};

}  // namespace deltamesh
