// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What both sides know at a gate, as contexts of the op that follows [CONN-12].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "connectivity/border.h"
#include "connectivity/cut.h"
#include "connectivity/traversal.h"

namespace deltamesh {

inline constexpr std::size_t kOpModels = 3;
inline constexpr std::array<std::uint32_t, kOpModels> kOpContexts = {10 * 10 * 8 * 4, 10 * 7 * 7 * 6 * 4,
                                                                     10 * 10 * 10 * 8};
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

/// How long the gate's loop is: 2, 3, 4 items, or more.
inline std::uint32_t loop_class(const Border& border, std::uint32_t gate) noexcept {
  const std::uint32_t before = border.item(gate).previous;
  const std::uint32_t after = border.item(gate).next;
  if (after == before) return 1;
  const std::uint32_t second = border.item(after).next;
  if (second == before) return 2;
  return border.item(second).next == before ? 3 : 0;
}

inline OpContext OpHistory::context_at(const Border& border, std::uint32_t gate,
                                       const GateContext& gate_context) noexcept {
  const std::uint32_t before = border.item(gate).previous;
  const std::uint32_t after = border.item(gate).next;
  const std::uint32_t beyond = border.item(after).next;
  const std::uint32_t origin = border.item(gate).origin;
  const std::uint32_t end = border.item(after).origin;
  const std::uint32_t focus = gate_context.at_origin ? origin : end;
  if (focus != focus_) {
    if (focus_ != kNoIndex) last_focus_faces_ = border.degree(focus_);
    focus_ = focus;
  }

  const auto faces_at = [&](std::uint32_t vertex) {
    return std::min<std::uint32_t>(border.degree(vertex), 9);
  };
  const std::uint32_t at_focus = faces_at(focus);
  const std::uint32_t at_other = faces_at(gate_context.at_origin ? end : origin);
  const std::uint32_t at_left = faces_at(border.item(before).origin);   // L's apex
  const std::uint32_t at_right = faces_at(border.item(beyond).origin);  // R's apex
  const std::uint32_t past_right = faces_at(border.item(border.item(beyond).next).origin);
  const std::uint32_t closed_after = border.item(after).closed ? 2 : 0;
  const std::uint32_t closed =
      (gate_context.other_side_closed ? 4 : 0) + closed_after + (border.item(before).closed ? 1 : 0);
  const std::uint32_t closed_coarse = (gate_context.other_side_closed ? 1 : 0) + closed_after;
  const std::uint32_t loop = loop_class(border, gate);
  const std::uint32_t last_faces = std::clamp<std::uint32_t>(last_focus_faces_, 3, 9) - 3;
  const std::uint32_t left_coarse = std::clamp<std::uint32_t>(at_left, 2, 7) - 2;
  return {.models = {((at_focus * 10 + at_other) * 8 + closed) * 4 + loop,
                     (((at_focus * 7 + last_faces) * 7 + last_symbol_) * 6 + left_coarse) * 4 + closed_coarse,
                     ((at_focus * 10 + past_right) * 10 + at_right) * 8 + closed},
          .weight_set = closed * 4 + loop};
}

}  // namespace deltamesh
