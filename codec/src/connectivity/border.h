// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The border of the region coded so far: the state that connectivity writer and reader share [CONN-3 .. 8].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "connectivity/cut.h"

namespace deltamesh {

/// What is found across a gate [CONN-6].
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
  bool closed = false;     ///< known to be a boundary edge of the mesh
  bool alive = true;
};

/// Items, faces and the queue of gaps. An item's number and origin never change. Loops have two items or
/// more, and no item ends where it begins.
class Border {
 public:
  const BorderItem& item(std::uint32_t i) const noexcept { return items_[i]; }
  std::uint32_t item_count() const noexcept { return static_cast<std::uint32_t>(items_.size()); }
  std::uint32_t vertex_count() const noexcept { return static_cast<std::uint32_t>(degrees_.size()); }
  std::uint32_t face_count() const noexcept { return static_cast<std::uint32_t>(faces_.size() / 3); }
  std::uint32_t third_after(std::uint32_t i) const noexcept {
    return items_[items_[items_[i].next].next].next;
  }
  /// Faces so far at a manifold vertex.
  std::uint32_t degree(std::uint32_t vertex) const noexcept { return degrees_[vertex]; }
  /// Manifold vertices of the faces, three each: gate's end, gate's origin, apex [CONN-6].
  std::vector<std::uint32_t> take_faces() noexcept { return std::move(faces_); }

  /// Room for a mesh of this size, so that nothing moves while it grows.
  void reserve(std::size_t vertices, std::size_t faces);

  /// A new component: a face of three new vertices, and its three edges as items, in the same order [CONN-4].
  void start();

  /// Whether the rules allow `op` at `gate`, an open item; `target` is S's item [CONN-7].
  bool allows(BorderOp op, std::uint32_t gate, std::uint32_t target) const noexcept;

  /// Carries `op` out. `at_origin`: the focus is the gate's origin, not its end [CONN-6]. Precondition:
  /// allows().
  void apply(BorderOp op, std::uint32_t gate, std::uint32_t target, bool at_origin);

  /// Takes the next gap that is not finished off the queue, kNoIndex when there is none [CONN-5]. Amortised
  /// O(1).
  std::uint32_t pop_gap() noexcept;

 private:
  /// Gaps wait by the number of faces at their origin, capped; the fullest go first, and among them the
  /// oldest.
  static constexpr std::size_t kBuckets = 16;
  struct Bucket {
    std::vector<std::uint32_t> gaps;
    std::size_t head = 0;
  };

  std::uint32_t add_item(std::uint32_t origin);
  void link(std::uint32_t a, std::uint32_t b) noexcept;
  void remove(std::uint32_t i) noexcept { items_[i].alive = false; }
  void add_new_vertex(std::uint32_t gate, bool at_origin);
  void split(std::uint32_t gate, std::uint32_t target, bool at_origin);
  void add_face(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void push_gap(std::uint32_t i);

  std::vector<BorderItem> items_;
  std::vector<std::uint32_t> degrees_;
  std::vector<std::uint32_t> faces_;
  std::array<Bucket, kBuckets> buckets_;
  std::size_t fullest_ = 0;  ///< no bucket above it holds a gap
};

inline std::uint32_t Border::add_item(std::uint32_t origin) {
  items_.push_back({.origin = origin, .previous = kNoIndex, .next = kNoIndex});
  return item_count() - 1;
}

inline void Border::link(std::uint32_t a, std::uint32_t b) noexcept {
  items_[a].next = b;
  items_[b].previous = a;
}

inline void Border::add_face(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  faces_.insert(faces_.end(), {a, b, c});
  ++degrees_[a];
  ++degrees_[b];
  ++degrees_[c];
}

inline void Border::add_new_vertex(std::uint32_t gate, bool at_origin) {
  const std::uint32_t after = items_[gate].next;
  const std::uint32_t apex = vertex_count();
  degrees_.push_back(0);
  add_face(items_[after].origin, items_[gate].origin, apex);
  const std::uint32_t fresh = add_item(apex);
  link(gate, fresh);
  link(fresh, after);
  if (!at_origin) push_gap(gate);
  push_gap(fresh);
  if (at_origin) push_gap(after);
}

inline void Border::push_gap(std::uint32_t i) {
  const std::size_t bucket = std::min<std::size_t>(degrees_[items_[i].origin], kBuckets - 1);
  buckets_[bucket].gaps.push_back(i);
  fullest_ = std::max(fullest_, bucket);
}

}  // namespace deltamesh
