// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "connectivity/faces/border.h"

namespace deltamesh {

namespace {

/// Room is made ready bit by bit, so that its first touch is in the cache when the faces come.
constexpr std::size_t kFacesAtOnce = 1024;
/// A face comes with an item at most, the first one of a component with three.
constexpr std::size_t kItemsAtOnce = 3 * kFacesAtOnce;

}  // namespace

void Border::reserve(std::size_t vertices, std::size_t faces) {
  items_.reserve(vertices + vertices / 8 + kItemsAtOnce);  // one per vertex and split
  faces_.reserve(3 * faces);
}

bool Border::make_room() {
  constexpr std::size_t kProof = 64 * kFacesAtOnce;  // that the rest will be filled as well
  constexpr std::size_t kGrowth = 4;
  const bool is_proved = face_room_ == 3 * kProof;
  const std::size_t had_room =
      std::exchange(face_room_, std::min(face_room_ + 3 * kFacesAtOnce, most_face_end_));
  const bool has_to_grow = had_room >= 3 * kProof && face_room_ > faces_.capacity();
  if (has_to_grow) faces_.reserve(std::min(kGrowth * had_room, most_face_end_));
  if (is_proved || has_to_grow) want_large_pages(faces_.data(), faces_.capacity() * sizeof(faces_[0]));
  if (is_proved) want_large_pages(items_.data(), items_.capacity() * sizeof(items_[0]));
  faces_.resize(face_room_);
  items_.resize(item_count_ + kItemsAtOnce);
  return face_end_ < face_room_;
}

std::vector<std::uint32_t> Border::take_faces() noexcept {
  faces_.resize(face_end_);
  return std::move(faces_);
}

void Border::start() {
  const std::uint32_t v = vertex_count_;
  const std::uint32_t i = item_count();
  first_item_ = i;
  vertex_count_ += 3;
  add_face(v, v + 1, v + 2);
  for (std::uint32_t k = 0; k < 3; ++k) add_item(v + k, i + (k + 2) % 3, i + (k + 1) % 3);
  for (std::uint32_t k = 0; k < 3; ++k) push_gap(i + k);
}

bool Border::add_left(const Gate& gate) {
  const std::uint32_t apex = items_[gate.before].origin;
  if (gate.before_closed || apex == gate.end) return false;
  add_face(gate.end, gate.origin, apex);
  link(gate.before, gate.after);
  remove(gate.item);
  count_face(gate.before);
  count_face(gate.after);
  push_gap(gate.before);
  return true;
}

bool Border::add_end(const Gate& gate) {
  if (gate.before_closed || gate.after_closed || gate.loop != 2) return false;
  add_face(gate.end, gate.origin, items_[gate.before].origin);
  remove(gate.before);
  remove(gate.item);
  remove(gate.after);
  leave_focus(one_more_face(gate.focus_faces));
  return true;
}

/// ```
///   <---target--- apex <---before target---       <---target--- apex <---before target---
///                                                               ^  |
///                                            ==>           gate |  | fresh
///                                                               |  v
///   ---before---> u ---gate---> v ---after--->    ---before---> u  v ---after--->
/// ```
bool Border::split(std::uint32_t target, const Gate& gate) {
  if (target < first_item_ || target >= item_count_ || !items_[target].alive) return false;
  const std::uint32_t apex = items_[target].origin;
  if (apex == gate.origin || apex == gate.end) return false;
  const std::uint32_t before_target = items_[target].previous;
  add_face(gate.end, gate.origin, apex);
  count_face(gate.item);
  count_face(gate.after);
  count_face(target);
  const std::uint32_t fresh = add_item(apex, kNoIndex, kNoIndex, items_[target].faces);
  link(gate.item, target);
  link(before_target, fresh);
  link(fresh, gate.after);
  if (!gate.at_origin) push_gap(gate.item);
  push_gap(fresh);
  push_gap(target);
  if (gate.at_origin) push_gap(gate.after);
  return true;
}

bool Border::apply_rare(const BorderStep& step, const Gate& gate) {
  if (step.op == BorderOp::kBoundary) {
    items_[gate.item].closed = true;
    open_edges_.push_back({gate.origin, gate.end});
    return true;
  }
  if (is_full()) return false;
  switch (step.op) {
    case BorderOp::kLeft:
      return add_left(gate);
    case BorderOp::kEnd:
      return add_end(gate);
    case BorderOp::kSplit:
      return split(step.target, gate);
    case BorderOp::kNearSplit:
      return split(gate.past, gate);
    default:
      return false;
  }
}

}  // namespace deltamesh
