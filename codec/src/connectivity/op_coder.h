// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Border ops by the compact coder, in the context of what both sides know at the gate [CONN-12].
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "connectivity/border.h"
#include "connectivity/op_history.h"
#include "connectivity/split_reference.h"
#include "connectivity/traversal.h"
#include "entropy/compact_model.h"
#include "entropy/number_model.h"

namespace deltamesh {

/// No stream has more: an op's probability is at most 1 - 2^-10.1, so that a byte holds at most 6060
/// [CONN-2].
inline constexpr std::uint64_t kFacesPerCompactByte = 8192;

/// `Coder` is CompactWriter or CompactReader.
template <class Coder>
class OpCoder {
 public:
  explicit OpCoder(Coder& coder) : coder_(coder) {
    for (std::size_t i = 0; i < kOpModels; ++i) models_[i].assign(kOpContexts[i], kFreshOp);
  }

  /// Writes `step`, or reads one; a reader's may not fit the border. None where there is no such op.
  [[gnu::always_inline]] BorderStep code(const BorderStep& step, const Border& border, std::uint32_t gate,
                                         const GateContext& gate_context) {
    const OpContext context = history_.context_at(border, gate, gate_context);
    const unsigned symbol = coder_.symbol(
        static_cast<unsigned>(step.op),
        Mixture<kOpModels>{
            {&models_[0][context.models[0]], &models_[1][context.models[1]], &models_[2][context.models[2]]},
            &weights_[context.weight_set]});
    if (symbol > static_cast<unsigned>(BorderOp::kNearSplit)) return {};
    history_.learn(symbol);
    BorderStep coded{static_cast<BorderOp>(symbol)};
    if (coded.op == BorderOp::kSplit) coded.target = code_target(step.target, border, gate);
    return coded;
  }

 private:
  std::uint32_t code_target(std::uint32_t target, const Border& border, std::uint32_t gate) {
    const std::uint32_t reference =
        coder_.number(Coder::kWrites ? find_reference(border, gate, target) : 0, references_);
    if (reference > kLargestReference) return kNoIndex;
    if (reference != kFarReference) return follow_reference(border, gate, reference);
    return coder_.bits(target, static_cast<unsigned>(std::bit_width(border.item_count())));
  }

  static constexpr SymbolModel kFreshOp{{60, 20, 60, 6, 2, 10, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1}};

  Coder& coder_;
  OpHistory history_;
  std::array<std::vector<SymbolModel>, kOpModels> models_;
  std::array<MixWeights<kOpModels>, kOpWeightSets> weights_;
  NumberModel references_;
};

}  // namespace deltamesh
