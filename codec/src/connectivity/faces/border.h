// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The border of the region coded so far: the state that connectivity writer and reader share [CONN-3 .. 8].
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/memory/large_vector.h"
#include "connectivity/faces/border_item.h"
#include "connectivity/faces/gap_queue.h"
#include "topology/adjacency.h"

namespace deltamesh {

/// Items, faces and the queue of gaps. An item's number and origin never change. Loops have two items or
/// more, and no item ends where it begins.
class Border {
 public:
  /// Never more than `most_faces` faces.
  explicit Border(std::uint32_t most_faces) noexcept : most_face_end_(std::size_t{3} * most_faces) {}

  const BorderItem& item(std::uint32_t i) const noexcept { return items_[i]; }
  std::uint32_t item_count() const noexcept { return item_count_; }
  std::uint32_t vertex_count() const noexcept { return vertex_count_; }
  bool is_full() const noexcept { return face_end_ == most_face_end_; }
  /// Manifold vertices of the faces, three each: gate's end, gate's origin, apex [CONN-6].
  std::span<const std::uint32_t> faces() const noexcept { return std::span(faces_).first(face_end_); }
  std::vector<std::uint32_t> take_faces() noexcept;

  /// Edges of one face, in its direction, over manifold vertices: closed loops once all gaps are finished.
  LargeVector<DirectedEdge> take_open_edges() noexcept { return std::move(open_edges_); }

  /// Room for a mesh of this size, so that nothing moves while it grows.
  void reserve(std::size_t vertices, std::size_t faces);

  /// A new component: a face of three new vertices, and its three edges as items, in the same order [CONN-4].
  /// Precondition: not full.
  void start();

  /// Item `i` and what lies around it. `AtOrigin`: the focus is its origin, not its end [CONN-6].
  template <bool AtOrigin>
  Gate gate_at(std::uint32_t i) const noexcept;

  /// Carries a step out at a gate. False where the rules do not allow it [CONN-7], or the border is full. The
  /// usual ops are inline, rare ones are not.
  bool apply(const BorderStep& step, const Gate& gate);

  /// The gate of step 1 [CONN-6] after op C at `gate`: what gate_at() would give for the new item, without
  /// looking at items again. Precondition: the loop was long.
  void advance(Gate& gate) const noexcept;

  /// Whether there is room for so many ops that add a face. Where there is none, one by one they make some,
  /// as far as the border is not full.
  bool has_room_for(std::uint32_t ops) const noexcept {
    return face_room_ - face_end_ >= std::size_t{3} * ops;
  }

  /// Applies `new_vertices` ops C and then R, which fill the gap. Preconditions: there is room for them, the
  /// gate is not at the focus' own item, and its loop has three items or more. False if the rules do not
  /// allow it [CONN-7].
  bool add_fan(const Gate& gate, std::uint32_t new_vertices);

  /// Takes the next gap that is not finished off the queue, kNoIndex when there is none [CONN-5]. Amortised
  /// O(1).
  std::uint32_t pop_gap() {
    return gaps_.pop([this](std::uint32_t i) { return is_finished(i); });
  }

  /// Remembers how many faces a filled gap has in the end.
  void leave_focus(std::uint32_t faces) noexcept { last_focus_faces_ = faces; }

 private:
  bool apply_rare(const BorderStep& step, const Gate& gate);
  bool is_finished(std::uint32_t i) const noexcept {
    const BorderItem& item = items_[i];
    return !item.alive || (item.closed && items_[item.previous].closed);
  }
  void link(std::uint32_t a, std::uint32_t b) noexcept {
    items_[a].next = b;
    items_[b].previous = a;
  }
  void remove(std::uint32_t i) noexcept { items_[i].alive = false; }
  /// Returns how many it has then.
  std::uint32_t count_face(std::uint32_t i) noexcept {
    const std::uint32_t faces = one_more_face(items_[i].faces);
    items_[i].faces = static_cast<std::uint8_t>(faces);
    return faces;
  }
  bool add_vertex(const Gate& gate);
  bool add_left(const Gate& gate);
  bool add_right(const Gate& gate);
  bool add_end(const Gate& gate);
  bool split(std::uint32_t target, const Gate& gate);
  /// False where the border is full. Items may move.
  bool add_face(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  /// There is room, as a face came with it.
  std::uint32_t add_item(std::uint32_t origin, std::uint32_t previous, std::uint32_t next,
                         std::uint8_t faces = 1) noexcept {
    items_[item_count_] = {
        .origin = origin, .previous = previous, .next = next, .faces = faces, .closed = false, .alive = true};
    return item_count_++;
  }
  bool make_room();
  void push_gap(std::uint32_t i) { push_gap(i, items_[i].faces); }
  [[gnu::always_inline]] void push_gap(std::uint32_t i, std::uint32_t faces) {
    gaps_.push(faces, i, [this](std::uint32_t gap) { return !items_[gap].alive; });
  }

  std::size_t most_face_end_;
  std::size_t face_end_ = 0;   ///< of the faces in `faces_`
  std::size_t face_room_ = 0;  ///< size of `faces_`
  std::uint32_t vertex_count_ = 0;
  std::uint32_t item_count_ = 0;
  std::uint32_t first_item_ = 0;  ///< of the component
  std::uint32_t last_focus_faces_ = 6;
  LargeVector<BorderItem> items_;     ///< and room for three with each face that there is room for
  std::vector<std::uint32_t> faces_;  ///< three for each face, and room for some more
  LargeVector<DirectedEdge> open_edges_;
  GapQueue gaps_;
};

inline bool Border::add_face(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  if (face_end_ == face_room_ && !make_room()) return false;
  std::uint32_t* const face = faces_.data() + face_end_;
  face[0] = a;
  face[1] = b;
  face[2] = c;
  face_end_ += 3;
  return true;
}

template <bool AtOrigin>
[[gnu::always_inline]] inline Gate Border::gate_at(std::uint32_t i) const noexcept {
  const BorderItem& item = items_[i];
  const BorderItem& before = items_[item.previous];
  const BorderItem& after = items_[item.next];
  const BorderItem& beyond = items_[after.next];
  Gate gate{
      .item = i, .before = item.previous, .after = item.next, .beyond = after.next, .past = beyond.next};
  gate.origin = item.origin;
  gate.end = after.origin;
  gate.at_origin = AtOrigin;
  gate.before_closed = before.closed;
  gate.after_closed = after.closed;
  gate.other_side_closed = AtOrigin || after.closed;
  gate.loop = loop_class(gate);
  gate.focus_faces = AtOrigin ? item.faces : after.faces;
  gate.other_faces = AtOrigin ? after.faces : item.faces;
  gate.left_faces = before.faces;
  gate.right_faces = beyond.faces;
  gate.past_faces = items_[gate.past].faces;
  gate.last_focus_faces = last_focus_faces_;
  return gate;
}

/// A new item's gap is not pushed: the gaps on both sides are, and it has more faces or is finished once
/// these are filled.
[[gnu::always_inline]] inline bool Border::add_vertex(const Gate& gate) {
  if (!add_face(gate.end, gate.origin, vertex_count_)) return false;
  const std::uint32_t fresh = add_item(vertex_count_++, gate.item, gate.after);
  items_[gate.item].next = fresh;
  items_[gate.after].previous = fresh;
  const std::uint32_t faces = count_face(gate.item);
  const std::uint32_t after_faces = count_face(gate.after);
  if (gate.at_origin) {
    push_gap(gate.after, after_faces);
  } else {
    push_gap(gate.item, faces);
  }
  return true;
}

/// Where the focus is the gate's end, it fills the gap.
[[gnu::always_inline]] inline bool Border::add_right(const Gate& gate) {
  const std::uint32_t apex = items_[gate.beyond].origin;
  if (gate.after_closed || apex == gate.origin) return false;
  if (!add_face(gate.end, gate.origin, apex)) return false;
  link(gate.item, gate.beyond);
  remove(gate.after);
  const std::uint32_t faces = count_face(gate.item);
  const std::uint32_t beyond_faces = count_face(gate.beyond);
  if (!gate.at_origin) {
    push_gap(gate.item, faces);
    leave_focus(one_more_face(gate.focus_faces));
  }
  push_gap(gate.beyond, beyond_faces);
  return true;
}

[[gnu::always_inline]] inline void Border::advance(Gate& gate) const noexcept {
  gate.before = gate.item;
  gate.before_closed = false;
  gate.item = item_count_ - 1;
  gate.origin = vertex_count_ - 1;
  gate.focus_faces = one_more_face(gate.focus_faces);
  gate.left_faces = one_more_face(gate.other_faces);
  gate.other_faces = 1;
}

[[gnu::always_inline]] inline bool Border::add_fan(const Gate& gate, std::uint32_t new_vertices) {
  BorderItem& beyond = items_[gate.beyond];
  if (gate.after_closed || (new_vertices == 0 && beyond.origin == gate.origin)) return false;
  std::uint32_t* face = faces_.data() + face_end_;
  std::uint32_t item = gate.item;
  std::uint32_t origin = gate.origin;
  std::uint32_t faces = one_more_face(gate.other_faces);
  const auto add = [&](std::uint32_t apex, std::uint32_t next) {
    face[0] = gate.end;
    face[1] = origin;
    face[2] = apex;
    face += 3;
    items_[item].next = next;
    items_[item].faces = static_cast<std::uint8_t>(faces);
    push_gap(item, faces);
  };
  for (std::uint32_t i = 0; i < new_vertices; ++i) {
    const std::uint32_t apex = vertex_count_++;
    const std::uint32_t fresh = add_item(apex, item, kNoIndex);
    add(apex, fresh);
    item = fresh;
    origin = apex;
    faces = 2;
  }
  add(beyond.origin, gate.beyond);
  const std::uint32_t beyond_faces = one_more_face(gate.right_faces);
  beyond.previous = item;
  beyond.faces = static_cast<std::uint8_t>(beyond_faces);
  push_gap(gate.beyond, beyond_faces);
  remove(gate.after);
  face_end_ += std::size_t{3} * (new_vertices + 1);
  leave_focus(std::min(gate.focus_faces + new_vertices + 1, kMostFaces));
  return true;
}

[[gnu::always_inline]] inline bool Border::apply(const BorderStep& step, const Gate& gate) {
  if (step.op == BorderOp::kNewVertex) return add_vertex(gate);
  if (step.op == BorderOp::kRight) return add_right(gate);
  return apply_rare(step, gate);
}

}  // namespace deltamesh
