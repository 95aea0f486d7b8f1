// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A tree of axis-aligned boxes around items of one or more corners, such as points and triangles. Ranges are
// halved at the median of the longest side, so the depth is at most 32 whatever the input, and an array
// serves as the stack of a query.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/numbers/vec3.h"

namespace deltamesh {

/// Built in O(m log m) for m items.
class BoxTree {
 public:
  /// `positions`: n, finite; `corners`: m x `corners_per_item` indices below n, m from 1 to 2^31 - 1. Keeps
  /// neither.
  BoxTree(std::span<const Vec3> positions, std::span<const std::uint32_t> corners,
          std::size_t corners_per_item);

  /// Calls visit(item) for all items but those in boxes of which is_too_far(squared distance from `p`) says
  /// so, near boxes first. The squared distance of a box is no more than that of any point in it, as dot()
  /// rounds.
  template <class IsTooFar, class Visit>
  void visit_near(const Vec3& p, IsTooFar is_too_far, Visit visit) const;

 private:
  /// In depth-first order: the left child of an inner node follows it.
  struct Node {
    Box box;
    std::uint32_t first = 0;  ///< leaf: its first entry of order_; inner: its right child
    std::uint32_t count = 0;  ///< leaf: its entries; inner: 0
  };
  static constexpr std::size_t kMaxDepth = 40;

  static double squared_distance(const Box& box, const Vec3& p) noexcept;

  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

template <class IsTooFar, class Visit>
void BoxTree::visit_near(const Vec3& p, IsTooFar is_too_far, Visit visit) const {
  struct Waiting {
    std::uint32_t node;
    double squared_distance;
  };
  // At most one node waits per level.
  std::array<Waiting, kMaxDepth> stack;
  std::size_t waiting = 0;
  stack[waiting++] = {0, squared_distance(nodes_[0].box, p)};
  while (waiting > 0) {
    const Waiting top = stack[--waiting];
    if (is_too_far(top.squared_distance)) continue;
    const Node& node = nodes_[top.node];
    for (std::uint32_t i = 0; i < node.count; ++i) visit(order_[node.first + i]);
    if (node.count > 0) continue;
    Waiting near{top.node + 1, squared_distance(nodes_[top.node + 1].box, p)};
    Waiting far{node.first, squared_distance(nodes_[node.first].box, p)};
    if (far.squared_distance < near.squared_distance) std::swap(near, far);
    stack[waiting++] = far;
    stack[waiting++] = near;
  }
}

}  // namespace deltamesh
