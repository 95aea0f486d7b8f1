// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The traversal of the faces that connectivity writer and reader have in common [CONN-3 .. 8]. The writer's
// guide finds each op in the mesh, the reader's in the payload.
#pragma once

#include <cstdint>

#include "base/small_code.h"
#include "connectivity/faces/border.h"

namespace deltamesh {

/// Fills the gap from its item on, its other side being closed: step 2 of [CONN-6]. Returns false as soon as
/// the guide has no step to give, or one that does not fit.
template <class Guide>
[[gnu::noinline]] bool fill_from_item(Border& border, std::uint32_t gap, Guide& guide) {
  while (!border.item(gap).closed) {
    const BorderStep step = guide.next(border, border.gate_at<true>(gap));
    if (!border.apply<true>(gap, step.op, step.target)) return false;
  }
  border.leave_focus(border.item(gap).faces);
  return true;
}

/// Fills the gap before item `gap` with faces, from its far side to the item itself [CONN-6]. Returns false
/// as fill_from_item() does. A guide may know of a run of steps before they are taken, and need not be asked
/// for those of a fan.
template <class Guide>
DELTAMESH_LOOP_BODY bool fill_gap(Border& border, std::uint32_t gap, Guide& guide) {
  while (!border.item(border.item(gap).previous).closed) {
    Gate gate = border.gate_at<false>(border.item(gap).previous);
    if constexpr (requires { guide.run(gate); }) {
      const auto run = guide.run(gate);
      if (run.is_fan() && gate.loop != 1 && border.has_room_for(run.new_vertices + 1))
        return border.add_fan(gate, run.new_vertices);
      guide.begin(run);
    }
    BorderStep step;
    for (;;) {
      step = guide.next(border, gate);
      if (step.op != BorderOp::kNewVertex || gate.loop != 0) break;
      if (!border.add_vertex_and_advance(gate)) return false;
    }
    if (step.op == BorderOp::kRight) return border.add_right_and_leave(gate);
    if (!border.apply<false>(gate.item, step.op, step.target)) return false;
    if (step.op == BorderOp::kEnd) return true;
  }
  return fill_from_item(border, gap, guide);
}

/// Codes faces until the border is full. `guide.start(border)` hears of every new component before its first
/// face; `guide.next(border, gate)` gives the step at a gate, or none to stop, as does `guide.failed()`
/// between gaps. Returns whether the end was reached. O(faces + ops).
template <class Guide>
bool traverse(Border& border, Guide& guide) {
  while (!border.is_full()) {
    guide.start(border);
    border.start();
    for (std::uint32_t gap = border.pop_gap(); gap != kNoIndex; gap = border.pop_gap()) {
      if (!fill_gap(border, gap, guide) || guide.failed()) return false;
    }
  }
  return true;
}

}  // namespace deltamesh
