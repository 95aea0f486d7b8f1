// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The walk over the faces that connectivity writer and reader have in common [CONN-3 .. 8]. The writer's
// guide finds each op in the mesh, the reader's in the payload; later entropy stages are guides as well.
#pragma once

#include <cstdint>

#include "connectivity/border.h"
#include "connectivity/cut.h"

namespace deltamesh {

/// What both sides know at a gate when its op is about to be coded.
struct GateContext {
  std::uint32_t focus_degree;  ///< faces so far at the focus
  bool at_origin;              ///< the focus is the gate's origin, not its end
  bool loop_of_three;          ///< the gate's loop has three items
  bool other_side_closed;      ///< the focus' gap ends at a boundary edge on its other side
};

struct BorderStep {
  BorderOp op = BorderOp::kNone;    ///< kNone: there is no step
  std::uint32_t target = kNoIndex;  ///< S: the item whose origin is the apex
};

/// Fills the gap before item `gap` with faces, from its far side to the item itself [CONN-6].
/// Returns false as soon as the guide has no step to give.
template <class Guide>
bool fill_gap(Border& border, std::uint32_t gap, Guide& guide) {
  const std::uint32_t focus = border.item(gap).origin;
  const auto step_at = [&](std::uint32_t gate, bool at_origin, bool other_side_closed) {
    const GateContext context{.focus_degree = border.degree(focus),
                              .at_origin = at_origin,
                              .loop_of_three = border.third_after(gate) == gate,
                              .other_side_closed = other_side_closed};
    const BorderStep step = guide.next(border, gate, context);
    if (step.op != BorderOp::kNone) border.apply(step.op, gate, step.target, at_origin);
    return step.op;
  };

  while (!border.item(border.item(gap).previous).closed) {
    const BorderOp op = step_at(border.item(gap).previous, false, border.item(gap).closed);
    if (op == BorderOp::kNone) return false;
    if (op == BorderOp::kRight || op == BorderOp::kEnd) return true;
  }
  while (!border.item(gap).closed) {
    if (step_at(gap, true, true) == BorderOp::kNone) return false;
  }
  return true;
}

/// Codes `face_count` faces. `guide.start(border)` hears of every new component before its first face;
/// `guide.next(border, gate, context)` gives a step that the border allows, and no face beyond `face_count`,
/// or none to stop. Returns whether the end was reached. O(faces + ops).
template <class Guide>
bool traverse(Border& border, std::uint32_t face_count, Guide& guide) {
  while (border.face_count() < face_count) {
    guide.start(border);
    border.start();
    for (std::uint32_t gap = border.pop_gap(); gap != kNoIndex; gap = border.pop_gap()) {
      if (!fill_gap(border, gap, guide)) return false;
    }
  }
  return true;
}

}  // namespace deltamesh
