// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Guides a writer's traversal by the mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/memory/large_vector.h"
#include "connectivity/faces/border.h"
#include "connectivity/faces/cut.h"
#include "connectivity/faces/faces.h"
#include "connectivity/faces/op_coder.h"
#include "connectivity/faces/traversal.h"
#include "entropy/coder/writer.h"
#include "topology/vertex_runs.h"

namespace deltamesh {

/// Vertices of the mesh as their manifold vertices appear; later manifold vertices of a vertex are glued
/// [CONN-11].
class VertexNumbers {
 public:
  explicit VertexNumbers(std::uint32_t vertex_count) : has_(vertex_count, 0) { order_.reserve(vertex_count); }

  bool has(std::uint32_t vertex) const noexcept { return has_[vertex] != 0; }

  /// The vertices to come are of the next component of manifold vertices.
  void start() { runs_.begin(static_cast<std::uint32_t>(order_.size())); }

  /// The next manifold vertex is one of `vertex`.
  void add(std::uint32_t vertex) {
    if (has(vertex)) {
      if (coded_.empty()) number_vertices();
      coded_.push_back(number_[vertex]);
      runs_.join(number_[vertex]);
      return;
    }
    has_[vertex] = 1;
    if (!coded_.empty()) {
      number_[vertex] = static_cast<std::uint32_t>(order_.size());
      coded_.push_back(number_[vertex]);
    }
    order_.push_back(vertex);
  }

  /// Number of every manifold vertex, or nothing where none is glued, so that each is its own.
  const std::vector<std::uint32_t>& coded() const noexcept { return coded_; }

  /// Components of the mesh: those of manifold vertices, of which glued ones are the same, and vertices that
  /// were never added. Before take_order().
  std::uint32_t count_components() {
    runs_.end(static_cast<std::uint32_t>(order_.size()));
    return runs_.count(static_cast<std::uint32_t>(has_.size()));
  }

  /// Vertices by number; those that were never added come last, ascending.
  std::vector<std::uint32_t> take_order() {
    if (order_.size() < has_.size()) {
      for (std::uint32_t v = 0; v < has_.size(); ++v) {
        if (!has(v)) order_.push_back(v);
      }
    }
    return std::move(order_);
  }

 private:
  /// Numbers matter from the first glued vertex on.
  void number_vertices() {
    number_.resize(has_.size(), kNoIndex);
    for (std::uint32_t i = 0; i < order_.size(); ++i) number_[order_[i]] = i;
    coded_.resize(order_.size());
    std::iota(coded_.begin(), coded_.end(), 0U);
  }

  std::vector<std::uint8_t> has_;
  std::vector<std::uint32_t> number_;  ///< of every vertex, once one is glued
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> coded_;
  VertexRuns runs_;  ///< of vertices whose manifold vertices hang together
};

/// Finds every op in the mesh and writes it down.
class MeshGuide {
 public:
  MeshGuide(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count)
      : triangles_(triangles),
        half_edges_(match_half_edges(triangles, vertex_count)),
        links_(half_edges_.opposite),
        vertices_(vertex_count),
        face_done_(triangles.size() / 3, 0) {
    across_.reserve(std::size_t{vertex_count} + vertex_count / 8);
    reserve_large(face_order_, face_done_.size());
    face_rotation_.reserve(face_done_.size());
    new_edges_.reserve(face_done_.size());
  }

  std::uint32_t face_count() const noexcept { return static_cast<std::uint32_t>(triangles_.size() / 3); }

  /// Traverses the faces until `border` is full of them, and their ops are in `writer`. Both are new.
  /// `start`: null for fresh models.
  void run(Border& border, CompactWriter& writer, const OpModels* start) {
    writer.reserve(2 * std::size_t{face_count()});
    border.reserve(face_count() / 2, face_count());
    ops_.emplace(writer, start != nullptr ? *start : OpModels());
    traverse(border, *this);
  }

  void start(const Border& border) {
    while (face_done_[next_face_] != 0) ++next_face_;
    const std::uint32_t first = 3 * next_face_;
    vertices_.start();
    take_face(first, kGateEdge | kLeftEdge | kRightEdge);
    for (std::uint32_t k = 0; k < 3; ++k) {
      vertices_.add(triangles_[first + k]);
      put_edge(border.item_count() + k, first + k);
    }
  }

  [[gnu::always_inline]] BorderStep next(const Border& border, const Gate& gate) {
    const BorderStep step = find_step(border, gate);
    ops_->code(step, border, gate);
    return step;
  }
  static constexpr bool failed() noexcept { return false; }

  VertexNumbers& vertices() noexcept { return vertices_; }
  std::vector<std::uint32_t> take_face_order() noexcept { return std::move(face_order_); }
  std::vector<std::uint8_t> take_face_rotation() noexcept { return std::move(face_rotation_); }
  /// CodedConnectivity::new_edges.
  std::vector<std::uint8_t> take_new_edges() {
    if (half_edges_.degenerate) return {};
    drop_repeated_edges();
    return std::move(new_edges_);
  }

 private:
  /// Bits of a coded face's edges, whose corners are the gate's end, its origin and the apex.
  static constexpr unsigned kGateEdge = 1;
  static constexpr unsigned kLeftEdge = 2;
  static constexpr unsigned kRightEdge = 4;

  /// Marks a link across which the face is coded; the rest of it is the item of that edge.
  static constexpr std::uint32_t kItem = 0x80000000;

  [[gnu::always_inline]] BorderStep find_step(const Border& border, const Gate& gate) {
    const std::uint32_t across = across_[gate.item];
    if (across == kNoIndex) return {BorderOp::kBoundary};
    const std::uint32_t left = next_in_face(across);       // from the gate's origin to the apex
    const std::uint32_t right = previous_in_face(across);  // from the apex to the gate's end
    const bool takes_left = links_[left] == (kItem | gate.before);
    const bool takes_right = links_[right] == (kItem | gate.after);
    take_face(across, (takes_left ? 0 : kLeftEdge) | (takes_right ? 0 : kRightEdge));

    if (takes_left && takes_right) return {BorderOp::kEnd};
    if (takes_right) {
      put_edge(gate.item, left);
      return {BorderOp::kRight};
    }
    if (takes_left) {
      put_edge(gate.before, right);
      return {BorderOp::kLeft};
    }
    const std::uint32_t apex = triangles_[right];
    BorderStep step{BorderOp::kNewVertex};
    if (vertices_.has(apex)) {
      const std::uint32_t target = find_target(border, left, right);
      if (target != kNoIndex) step = {target == gate.past ? BorderOp::kNearSplit : BorderOp::kSplit, target};
    }
    if (step.op == BorderOp::kNewVertex) vertices_.add(apex);
    put_edge(gate.item, left);
    put_edge(border.item_count(), right);
    return step;
  }

  /// The item whose gap at the apex holds the new face, or kNoIndex where no face of this fan is coded. Turns
  /// around the apex both ways at once until one meets the coded region, so that a gap is searched at the
  /// cost of its smaller half.
  [[gnu::noinline]] std::uint32_t find_target(const Border& border, std::uint32_t left,
                                              std::uint32_t right) const {
    const std::uint32_t first_left = left;
    const std::uint32_t first_right = right;
    while (left != kNoIndex || right != kNoIndex) {
      // `left` runs into the apex, so what is across runs out of it; `right` the other way round.
      if (left != kNoIndex) left = links_[left];
      if (left != kNoIndex) {
        if ((left & kItem) != 0) return left & ~kItem;
        if (left == first_right) return kNoIndex;
        left = previous_in_face(left);
      }
      if (right != kNoIndex) right = links_[right];
      if (right != kNoIndex) {
        if ((right & kItem) != 0) return border.item(right & ~kItem).next;
        if (right == first_left) return kNoIndex;
        right = next_in_face(right);
      }
    }
    return kNoIndex;
  }

  /// Keeps one of the manifold edges between two vertices.
  void drop_repeated_edges() {
    if (half_edges_.repeated.empty()) return;
    std::vector<std::uint8_t> repeated(face_count());
    for (const std::uint32_t h : half_edges_.repeated)
      repeated[h / 3] |= static_cast<std::uint8_t>(9U << h % 3);  // once more, so that it can be turned
    for (std::size_t f = 0; f < new_edges_.size(); ++f)
      new_edges_[f] &= static_cast<std::uint8_t>(~(repeated[face_order_[f]] >> face_rotation_[f]));
  }

  void take_face(std::uint32_t first_corner, unsigned new_edges) {
    const std::uint32_t face = first_corner / 3;
    face_done_[face] = 1;
    face_order_.push_back(face);
    face_rotation_.push_back(static_cast<std::uint8_t>(first_corner - 3 * face));
    new_edges_.push_back(static_cast<std::uint8_t>(new_edges));
  }
  void put_edge(std::uint32_t item, std::uint32_t half_edge) {
    const std::uint32_t across = links_[half_edge];
    if (item == across_.size()) across_.push_back(across);
    across_[item] = across;
    if (across == kNoIndex) return;
    links_[across] = kItem | item;
    // The face across is asked for soon, and lies anywhere.
    __builtin_prefetch(&triangles_[across]);
  }

  std::span<const std::uint32_t> triangles_;
  HalfEdges half_edges_;
  std::vector<std::uint32_t>& links_;  ///< across every half-edge: a half-edge, an item, or nothing
  VertexNumbers vertices_;
  std::optional<OpCoder<CompactWriter>> ops_;
  std::vector<std::uint8_t> face_done_;
  std::vector<std::uint32_t> across_;  ///< the half-edge across every item's edge
  std::uint32_t next_face_ = 0;
  std::vector<std::uint32_t> face_order_;
  std::vector<std::uint8_t> face_rotation_;
  std::vector<std::uint8_t> new_edges_;
};

}  // namespace deltamesh
