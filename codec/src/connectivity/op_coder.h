// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Border ops by the compact coder, in the context of what both sides know at the gate [CONN-12].
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "connectivity/border.h"
#include "connectivity/split_reference.h"
#include "connectivity/traversal.h"
#include "entropy/compact_model.h"
#include "entropy/number_model.h"

namespace deltamesh {

inline constexpr std::size_t kOpModels = 4;
inline constexpr std::array<std::uint32_t, kOpModels> kOpContexts = {10 * 10 * 8 * 4, 10 * 10 * 10 * 8,
                                                                     10 * 7 * 7 * 6 * 4, 10 * 10 * 10 * 8};
inline constexpr std::uint32_t kOpWeightSets = 8 * 4;

struct OpContext {
  std::array<std::uint32_t, kOpModels> models;
  std::uint32_t weight_set;
};

/// Remembers of the ops so far what contexts need.
class OpHistory {
 public:
  /// Cost O(1), no more than six steps along the loop.
  OpContext context_at(const Border& border, std::uint32_t gate, const GateContext& gate_context) noexcept;
  void learn(unsigned symbol) noexcept { last_symbol_ = symbol; }

 private:
  std::uint32_t focus_ = kNoIndex;
  std::uint32_t last_focus_faces_ = 6;  ///< faces at the focus before, when it was left
  unsigned last_symbol_ = 0;
};

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

  /// Writes `step`, or reads one; a reader's may not fit the border. Nothing where there is no such op.
  std::optional<BorderStep> code(const BorderStep& step, const Border& border, std::uint32_t gate,
                                 const GateContext& gate_context) {
    const OpContext context = history_.context_at(border, gate, gate_context);
    const unsigned symbol =
        coder_.symbol(static_cast<unsigned>(step.op),
                      Mixture<kOpModels>{{&models_[0][context.models[0]], &models_[1][context.models[1]],
                                          &models_[2][context.models[2]], &models_[3][context.models[3]]},
                                         &weights_[context.weight_set]});
    if (symbol > static_cast<unsigned>(BorderOp::kNearSplit)) return std::nullopt;
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
