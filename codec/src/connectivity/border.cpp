// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "connectivity/border.h"

#include <algorithm>

#include "connectivity/cut.h"

namespace deltamesh {

void Border::reserve(std::size_t vertices, std::size_t faces) {
  items_.reserve(vertices + vertices / 8);  // one per vertex and split
  degrees_.reserve(vertices);
  faces_.reserve(3 * faces);
}

void Border::start() {
  const std::uint32_t v = vertex_count();
  const std::uint32_t i = item_count();
  degrees_.resize(degrees_.size() + 3, 0);
  add_face(v, v + 1, v + 2);
  for (std::uint32_t k = 0; k < 3; ++k) add_item(v + k);
  for (std::uint32_t k = 0; k < 3; ++k) link(i + k, i + (k + 1) % 3);
  for (std::uint32_t k = 0; k < 3; ++k) push_gap(i + k);
}

bool Border::allows(BorderOp op, std::uint32_t gate, std::uint32_t target) const noexcept {
  const BorderItem& g = items_[gate];
  const BorderItem& before = items_[g.previous];
  const BorderItem& after = items_[g.next];
  switch (op) {
    case BorderOp::kNewVertex:
    case BorderOp::kBoundary:
      return true;
    case BorderOp::kLeft:
      return !before.closed && before.origin != after.origin;
    case BorderOp::kRight:
      return !after.closed && items_[after.next].origin != g.origin;
    case BorderOp::kEnd:
      return !before.closed && !after.closed && g.previous != g.next && after.next == g.previous;
    case BorderOp::kSplit:
      break;
    case BorderOp::kNearSplit:
      target = third_after(gate);
      break;
    case BorderOp::kNone:
      return false;
  }
  return target < items_.size() && items_[target].alive && items_[target].origin != g.origin &&
         items_[target].origin != after.origin;
}

/// ```
///   <---target--- apex <---before target---       <---target--- apex <---before target---
///                                                               ^  |
///                                            ==>           gate |  | fresh
///                                                               |  v
///   ---before---> u ---gate---> v ---after--->    ---before---> u  v ---after--->
/// ```
void Border::split(std::uint32_t gate, std::uint32_t target, bool at_origin) {
  const std::uint32_t after = items_[gate].next;
  const std::uint32_t before_target = items_[target].previous;
  add_face(items_[after].origin, items_[gate].origin, items_[target].origin);
  const std::uint32_t fresh = add_item(items_[target].origin);
  link(gate, target);
  link(before_target, fresh);
  link(fresh, after);
  if (!at_origin) push_gap(gate);
  push_gap(fresh);
  push_gap(target);
  if (at_origin) push_gap(after);
}

void Border::apply(BorderOp op, std::uint32_t gate, std::uint32_t target, bool at_origin) {
  const std::uint32_t before = items_[gate].previous;
  const std::uint32_t after = items_[gate].next;
  switch (op) {
    case BorderOp::kNewVertex:
      add_new_vertex(gate, at_origin);
      return;
    case BorderOp::kLeft:
      add_face(items_[after].origin, items_[gate].origin, items_[before].origin);
      link(before, after);
      remove(gate);
      push_gap(before);
      return;
    case BorderOp::kRight: {
      const std::uint32_t beyond = items_[after].next;
      add_face(items_[after].origin, items_[gate].origin, items_[beyond].origin);
      link(gate, beyond);
      remove(after);
      if (!at_origin) push_gap(gate);
      push_gap(beyond);
      return;
    }
    case BorderOp::kEnd:
      add_face(items_[after].origin, items_[gate].origin, items_[before].origin);
      remove(before);
      remove(gate);
      remove(after);
      return;
    case BorderOp::kSplit:
      split(gate, target, at_origin);
      return;
    case BorderOp::kBoundary:
      items_[gate].closed = true;
      return;
    case BorderOp::kNearSplit:
      split(gate, third_after(gate), at_origin);
      return;
    case BorderOp::kNone:
      return;
  }
}

std::uint32_t Border::pop_gap() noexcept {
  for (;;) {
    Bucket& bucket = buckets_[fullest_];
    while (bucket.head < bucket.gaps.size()) {
      const std::uint32_t i = bucket.gaps[bucket.head++];
      if (items_[i].alive && !(items_[i].closed && items_[items_[i].previous].closed)) return i;
    }
    bucket.gaps.clear();
    bucket.head = 0;
    if (fullest_ == 0) return kNoIndex;
    --fullest_;
  }
}

}  // namespace deltamesh
