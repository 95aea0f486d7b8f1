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

#include "connectivity/border.h"
#include "connectivity/decision.h"
#include "connectivity/split_reference.h"
#include "entropy/number_model.h"

namespace deltamesh {

/// No stream has more: a decision's probability is at most 1 - 24 / 2^15, so that a byte holds at most 7568
/// [CONN-2].
inline constexpr std::uint64_t kFacesPerCompactByte = 8192;

/// `Coder` is CompactWriter or CompactReader.
template <class Coder>
class OpCoder {
 public:
  explicit OpCoder(Coder& coder) : coder_(coder) {}

  /// Writes `step`, or reads one; a reader's may not fit the border.
  [[gnu::always_inline]] BorderStep code(const BorderStep& step, const Border& border, const Gate& gate) {
    const std::uint32_t focus = gate.focus_faces - 1;
    const std::uint32_t closed = (gate.after_closed ? 2 : 0) + (gate.other_side_closed ? 1 : 0);
    const std::uint32_t around = ((gate.left_faces - 1) * 4 + closed) * 4 + gate.loop;
    const std::uint32_t ahead =
        (((focus * 8 + gate.past_faces - 1) * 8 + gate.right_faces - 1) * 4 + closed) * 4 +
        few(gate.other_faces);
    const std::uint32_t set = last_kind_ * 4 + gate.loop;
    if (is_new_.code(coder_, step.op == BorderOp::kNewVertex,
                     {(focus * 8 + gate.last_focus_faces - 1) * 128 + around, ahead, set})) {
      last_kind_ = 0;
      return {BorderOp::kNewVertex};
    }
    if (is_right_.code(coder_, step.op == BorderOp::kRight, {focus * 128 + around, ahead, set})) {
      last_kind_ = 1;
      return {BorderOp::kRight};
    }
    last_kind_ = 2;
    return gate.at_origin ? code_rare<true>(step.op, step.target, border, gate.item)
                          : code_rare<false>(step.op, step.target, border, gate.item);
  }

 private:
  /// The ops other than C and R, most frequent first; E is what is left.
  static constexpr std::array kRareOps = {BorderOp::kBoundary, BorderOp::kLeft, BorderOp::kSplit,
                                          BorderOp::kNearSplit};

  static std::uint32_t few(std::uint32_t faces) noexcept { return std::min<std::uint32_t>(faces, 4) - 1; }

  template <bool AtOrigin>
  [[gnu::noinline]] BorderStep code_rare(BorderOp op, std::uint32_t target, const Border& border,
                                         std::uint32_t item) {
    const Gate gate = border.gate_at<AtOrigin>(item);
    const std::uint32_t closed =
        (gate.other_side_closed ? 4 : 0) + (gate.after_closed ? 2 : 0) + (gate.before_closed ? 1 : 0);
    const std::uint32_t near = closed * 4 + gate.loop;
    const DecisionContext context{.first = (near * 8 + gate.focus_faces - 1) * 4 + few(gate.other_faces),
                                  .second = (near * 8 + gate.left_faces - 1) * 8 + gate.right_faces - 1,
                                  .set = 0};
    for (std::size_t i = 0; i < kRareOps.size(); ++i) {
      if (!is_rare_[i].code(coder_, op == kRareOps[i], context)) continue;
      BorderStep coded{kRareOps[i]};
      if (coded.op == BorderOp::kSplit) coded.target = code_target(target, border, item);
      return coded;
    }
    return {BorderOp::kEnd};
  }

  std::uint32_t code_target(std::uint32_t target, const Border& border, std::uint32_t gate) {
    const std::uint32_t reference =
        coder_.number(Coder::kWrites ? find_reference(border, gate, target) : 0, references_);
    if (reference > kLargestReference) return kNoIndex;
    if (reference != kFarReference) return follow_reference(border, gate, reference);
    return coder_.bits(target, static_cast<unsigned>(std::bit_width(border.item_count())));
  }

  static Decision rare_decision() { return Decision(8 * 4 * 8 * 4, 8 * 4 * 8 * 8, 1, 32768); }

  Coder& coder_;
  std::uint32_t last_kind_ = 0;  ///< of op: C, R, or another
  Decision is_new_{8 * 8 * 128, 8 * 8 * 8 * 4 * 4, 12, 32768};
  Decision is_right_{8 * 128, 8 * 8 * 8 * 4 * 4, 12, 58982};
  std::array<Decision, kRareOps.size()> is_rare_ = {rare_decision(), rare_decision(), rare_decision(),
                                                    rare_decision()};
  NumberModel references_;
};

}  // namespace deltamesh
