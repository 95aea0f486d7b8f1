// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/surface_order.h"

#include <vector>

namespace deltamesh {
namespace {

class OrderMaker {
 public:
  OrderMaker(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count,
             const VertexCorners& corners, SurfaceOrder& order)
      : triangles_(triangles),
        corners_(corners),
        order_(order),
        met_(triangles.size() / 3),
        ready_(vertex_count) {
    order.vertices.reserve(vertex_count);
    order.ends.reserve(vertex_count);
    order.complete.reserve(met_.size());
  }

  void run() {
    for (std::size_t c = 0; c < triangles_.size(); ++c) {
      visit_once(triangles_[c]);
      if (c % 3 == 2) follow();
    }
    for (std::uint32_t v = 0; v < ready_.size(); ++v) visit_once(v);
  }

 private:
  static constexpr std::uint8_t kSeveral = 2;
  static constexpr std::uint8_t kVisited = 255;

  void visit_once(std::uint32_t vertex) {
    if (ready_[vertex] != kVisited) visit(vertex);
  }

  void visit(std::uint32_t vertex) {
    ready_[vertex] = kVisited;
    for (const Corner& corner : corners_.of(vertex)) {
      const std::uint8_t met = ++met_[corner.face];
      if (met == 3) order_.complete.push_back(corner);
      // Two corners were visited, so that the third is the only one to come, if there is one.
      if (met == 2) push(ready_[corner.next] == kVisited ? corner.before : corner.next);
    }
    order_.vertices.push_back(vertex);
    order_.ends.push_back(static_cast<std::uint32_t>(order_.complete.size()));
  }

  /// One more face waits for `vertex`, if that is still to come.
  void push(std::uint32_t vertex) {
    std::uint8_t& ready = ready_[vertex];
    if (ready == kVisited) return;
    if (ready < kSeveral) ++ready;
    (ready == kSeveral ? queue_ : stack_).push_back(vertex);
  }

  /// Visits the vertices that faces wait for until there are none: those of several faces first, the first of
  /// them first; then the last of the others. A face pushes one vertex at most.
  void follow() {
    for (;;) {
      if (next_ < queue_.size()) {
        visit_once(queue_[next_++]);
      } else if (!stack_.empty()) {
        const std::uint32_t vertex = stack_.back();
        stack_.pop_back();
        visit_once(vertex);
      } else {
        return;
      }
    }
  }

  std::span<const std::uint32_t> triangles_;
  const VertexCorners& corners_;
  SurfaceOrder& order_;
  std::vector<std::uint8_t> met_;     ///< by face: how many of its corners were visited
  std::vector<std::uint8_t> ready_;   ///< by vertex: faces that wait for it, at most kSeveral, or kVisited
  std::vector<std::uint32_t> stack_;  ///< vertices that one face waits for
  std::vector<std::uint32_t> queue_;  ///< those that several do
  std::size_t next_ = 0;              ///< of the queue
};

}  // namespace

SurfaceOrder make_surface_order(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count,
                                const VertexCorners& corners) {
  SurfaceOrder order;
  OrderMaker(triangles, vertex_count, corners, order).run();
  return order;
}

}  // namespace deltamesh
