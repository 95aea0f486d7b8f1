// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Items of the border, the gates among them, and the ops that change it [CONN-3, CONN-6].
#pragma once

#include <cstdint>

#include "connectivity/faces/cut.h"

namespace deltamesh {

/// Ops, by what is across the gate [CONN-6].
enum class BorderOp : std::uint32_t {
  kNewVertex = 0,  ///< C: a face whose apex is a new manifold vertex
  kLeft = 1,       ///< L: a face that also takes the edge before the gate
  kRight = 2,      ///< R: a face that also takes the edge after the gate
  kEnd = 3,        ///< E: a face that takes both, and thereby the whole loop
  kSplit = 4,      ///< S: a face whose apex is the origin of another border item
  kBoundary = 5,   ///< B: no face
  kNearSplit = 6,  ///< N: S whose target is the third item after the gate
  kNone = 255,     ///< nothing; never coded
};

struct BorderStep {
  BorderOp op = BorderOp::kNone;    ///< kNone: there is no step
  std::uint32_t target = kNoIndex;  ///< S: the item whose origin is the apex
};

/// Faces at an item's origin are counted up to here.
inline constexpr std::uint32_t kMostFaces = 8;
constexpr std::uint32_t one_more_face(std::uint32_t faces) noexcept {
  return faces + (faces < kMostFaces ? 1 : 0);
}

/// One directed edge of the border, with the coded region on its left. It also stands for the gap before it:
/// the wedge at its origin between the previous item's edge and its own, where faces may still be missing.
///
/// ```
///               coded region
///   ---previous---> u ---item---> v ---next--->      u: the item's origin
///                     (missing)
/// ```
struct BorderItem {
  std::uint32_t origin;    ///< manifold vertex
  std::uint32_t previous;  ///< item that ends at `origin`
  std::uint32_t next;      ///< item that begins where this one ends
  std::uint8_t faces;      ///< at `origin`, as far as this item saw them
  bool closed;             ///< known to be a boundary edge of the mesh
  bool alive;
};

/// A gate and its surroundings on the border: all that writer and reader know when its op is about to be
/// coded.
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
