// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A gate and its surroundings on the border: all that writer and reader know when its op is about to be
// coded.
#pragma once

#include <cstdint>

namespace deltamesh {

struct Gate {
  std::uint32_t item;
  std::uint32_t before;  ///< the items around it; the same ones again where the loop is short
  std::uint32_t after;
  std::uint32_t beyond;    ///< after `after`
  std::uint32_t past;      ///< after `beyond`
  std::uint32_t origin{};  ///< manifold vertices
  std::uint32_t end{};
  bool at_origin{};  ///< the focus is the origin, not the end
  bool before_closed{};
  bool after_closed{};
  bool other_side_closed{};          ///< the focus' gap ends at a boundary edge on its other side
  std::uint32_t loop{};              ///< items in the loop: 2, 3, 4 are 1, 2, 3; more are 0
  std::uint32_t focus_faces{};       ///< faces so far at the focus, counted as in BorderItem
  std::uint32_t other_faces{};       ///< at the other end
  std::uint32_t left_faces{};        ///< at L's apex
  std::uint32_t right_faces{};       ///< at R's apex
  std::uint32_t past_faces{};        ///< at the origin of `past`
  std::uint32_t last_focus_faces{};  ///< at the focus of the gap filled before, in the end
};

/// How long the gate's loop is.
constexpr std::uint32_t loop_class(const Gate& gate) noexcept {
  if (gate.after == gate.before) return 1;
  if (gate.beyond == gate.before) return 2;
  return gate.past == gate.before ? 3 : 0;
}

}  // namespace deltamesh
