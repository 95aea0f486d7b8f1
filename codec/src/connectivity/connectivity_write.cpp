// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <cstddef>
#include <utility>

#include "base/byte_writer.h"
#include "base/prefetch.h"
#include "base/zigzag.h"
#include "connectivity/border.h"
#include "connectivity/connectivity.h"
#include "connectivity/cut.h"
#include "connectivity/gluing.h"
#include "connectivity/op_coder.h"
#include "connectivity/op_tokens.h"
#include "connectivity/split_reference.h"
#include "connectivity/traversal.h"
#include "entropy/compact_writer.h"
#include "entropy/planes.h"

namespace deltamesh {
namespace {

/// Finds every op in the cut mesh and writes it down.
class MeshGuide {
 public:
  MeshGuide(const ManifoldCut& cut, CompactWriter& writer)
      : cut_(cut),
        ops_(writer),
        face_done_(cut.opposite.size() / 3, 0),
        vertex_done_(cut.vertex.size(), 0),
        item_at_(cut.opposite.size(), kNoIndex) {
    first_corner_.reserve(face_done_.size());
    vertices_.reserve(vertex_done_.size());
    edge_of_.reserve(vertex_done_.size() + vertex_done_.size() / 8);
  }

  void start(const Border& border) {
    while (face_done_[next_face_] != 0) ++next_face_;
    const std::uint32_t first = 3 * next_face_;
    take_face(first);
    for (std::uint32_t k = 0; k < 3; ++k) {
      take_vertex(cut_.manifold_vertex[first + k]);
      put_edge(border.item_count() + k, first + k);
    }
  }

  BorderStep next(const Border& border, const Gate& gate) {
    const BorderStep step = find_step(border, gate);
    tokens_.put(step.op, gate);
    ops_.code(step, border, gate);
    if (step.op == BorderOp::kSplit) put_reference(border, gate.item, step.target);
    return step;
  }

  static constexpr bool failed() noexcept { return false; }

  const TokenWriter& tokens() const noexcept { return tokens_; }
  const std::vector<std::byte>& references() const noexcept { return references_; }
  const std::vector<std::uint32_t>& far_targets() const noexcept { return far_targets_; }
  /// Corner of the cut mesh that is corner 0 of every coded face.
  const std::vector<std::uint32_t>& first_corner() const noexcept { return first_corner_; }
  /// Manifold vertex of the cut for every coded one.
  const std::vector<std::uint32_t>& vertices() const noexcept { return vertices_; }

 private:
  BorderStep find_step(const Border& border, const Gate& gate) {
    const std::uint32_t across = cut_.opposite[edge_of_[gate.item]];
    if (across == kNoIndex) return {BorderOp::kBoundary};
    const std::uint32_t left = next_in_face(across);       // from the gate's origin to the apex
    const std::uint32_t right = previous_in_face(across);  // from the apex to the gate's end
    const bool takes_left = cut_.opposite[left] == edge_of_[gate.before];
    const bool takes_right = cut_.opposite[right] == edge_of_[gate.after];
    take_face(across);

    if (takes_left && takes_right) return {BorderOp::kEnd};
    if (takes_left) {
      put_edge(gate.before, right);
      return {BorderOp::kLeft};
    }
    if (takes_right) {
      put_edge(gate.item, left);
      return {BorderOp::kRight};
    }
    const std::uint32_t apex = cut_.manifold_vertex[right];
    BorderStep step{BorderOp::kNewVertex};
    if (vertex_done_[apex] != 0) {
      const std::uint32_t target = find_target(border, left, right);
      step = {target == gate.past ? BorderOp::kNearSplit : BorderOp::kSplit, target};
    } else {
      take_vertex(apex);
    }
    put_edge(gate.item, left);
    put_edge(border.item_count(), right);
    return step;
  }

  /// The item whose gap at the apex holds the new face: turns around the apex both ways at once until one
  /// meets the coded region, so that a gap is searched at the cost of its smaller half.
  std::uint32_t find_target(const Border& border, std::uint32_t left, std::uint32_t right) const {
    for (;;) {
      // `left` runs into the apex, so its opposite runs out of it; `right` the other way round.
      if (left != kNoIndex) left = cut_.opposite[left];
      if (left != kNoIndex) {
        if (item_at_[left] != kNoIndex) return item_at_[left];
        left = previous_in_face(left);
      }
      if (right != kNoIndex) right = cut_.opposite[right];
      if (right != kNoIndex) {
        if (item_at_[right] != kNoIndex) return border.item(item_at_[right]).next;
        right = next_in_face(right);
      }
    }
  }

  void put_reference(const Border& border, std::uint32_t gate, std::uint32_t target) {
    const std::uint32_t reference = find_reference(border, gate, target);
    references_.push_back(static_cast<std::byte>(reference));
    if (reference == kFarReference) far_targets_.push_back(target);
  }

  void take_face(std::uint32_t first_corner) {
    face_done_[first_corner / 3] = 1;
    first_corner_.push_back(first_corner);
  }
  void take_vertex(std::uint32_t v) {
    vertex_done_[v] = 1;
    vertices_.push_back(v);
  }
  void put_edge(std::uint32_t item, std::uint32_t half_edge) {
    if (item == edge_of_.size()) edge_of_.push_back(half_edge);
    edge_of_[item] = half_edge;
    item_at_[half_edge] = item;
    // The face across is asked for soon, and lies anywhere.
    const std::uint32_t across = cut_.opposite[half_edge];
    if (across == kNoIndex) return;
    prefetch(&cut_.opposite[across]);
    prefetch(&cut_.manifold_vertex[across]);
    prefetch(&item_at_[across]);
  }

  const ManifoldCut& cut_;
  OpCoder<CompactWriter> ops_;
  std::vector<std::uint8_t> face_done_;
  std::vector<std::uint8_t> vertex_done_;
  std::vector<std::uint32_t> item_at_;  ///< item of every half-edge that ever was on the border
  std::vector<std::uint32_t> edge_of_;  ///< half-edge of every item
  std::uint32_t next_face_ = 0;
  TokenWriter tokens_;
  std::vector<std::byte> references_;
  std::vector<std::uint32_t> far_targets_;
  std::vector<std::uint32_t> first_corner_;
  std::vector<std::uint32_t> vertices_;
};

/// Vertices of the mesh as their manifold vertices appear; later manifold vertices of a vertex are glued
/// [CONN-11].
struct Gluing {
  GlueList list;
  std::vector<std::uint32_t> coded_vertex;  ///< of every coded manifold vertex
  std::vector<std::uint32_t> vertex_order;
};

Gluing find_gluing(std::span<const std::uint32_t> manifold_order, const ManifoldCut& cut,
                   std::uint32_t vertex_count) {
  Gluing gluing;
  gluing.coded_vertex.reserve(manifold_order.size());
  gluing.vertex_order.reserve(vertex_count);
  std::vector<std::uint32_t> number(vertex_count, kNoIndex);
  std::uint32_t gap = 0;
  std::uint32_t last_target = 0;
  for (const std::uint32_t manifold_vertex : manifold_order) {
    const std::uint32_t v = cut.vertex[manifold_vertex];
    if (number[v] == kNoIndex) {
      number[v] = static_cast<std::uint32_t>(gluing.vertex_order.size());
      gluing.vertex_order.push_back(v);
      ++gap;
    } else {
      gluing.list.gaps.push_back(gap);
      gluing.list.targets.push_back(zigzag(static_cast<std::int32_t>(number[v] - last_target)));
      gap = 0;
      last_target = number[v];
    }
    gluing.coded_vertex.push_back(number[v]);
  }
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    if (number[v] == kNoIndex) gluing.vertex_order.push_back(v);
  }
  return gluing;
}

std::vector<std::byte> write_payload(const MeshGuide& guide, const Gluing& gluing) {
  ByteWriter out;
  for (std::size_t i = 0; i < kTokenStreams; ++i) out.write_varint(guide.tokens().stream(i).size());
  out.write_varint(guide.references().size());
  out.write_varint(guide.far_targets().size());
  out.write_varint(gluing.list.gaps.size());
  for (std::size_t i = 0; i < kTokenStreams; ++i) out.write_bytes(guide.tokens().stream(i));
  out.write_bytes(guide.references());
  write_planes(out, guide.far_targets());
  write_planes(out, gluing.list.gaps);
  write_planes(out, gluing.list.targets);
  return out.take();
}

}  // namespace

CodedConnectivity write_connectivity(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count) {
  const ManifoldCut cut = cut_to_manifold(triangles, vertex_count);
  const auto face_count = static_cast<std::uint32_t>(triangles.size() / 3);
  Border border(face_count);
  border.reserve(cut.vertex.size(), triangles.size() / 3);
  CompactWriter writer;
  MeshGuide guide(cut, writer);
  traverse(border, guide);
  Gluing gluing = find_gluing(guide.vertices(), cut, vertex_count);

  CodedConnectivity coded;
  if (!triangles.empty()) {
    coded.payload = write_payload(guide, gluing);
  }
  coded.triangles = border.take_faces();
  if (!triangles.empty()) {
    write_compact_gluing(writer, gluing.list, coded.triangles, gluing.coded_vertex);
    coded.compact = writer.finish();
  }
  for (std::uint32_t& v : coded.triangles) v = gluing.coded_vertex[v];
  coded.vertex_order = std::move(gluing.vertex_order);
  coded.face_order.reserve(guide.first_corner().size());
  coded.face_rotation.reserve(guide.first_corner().size());
  for (const std::uint32_t corner : guide.first_corner()) {
    coded.face_order.push_back(corner / 3);
    coded.face_rotation.push_back(static_cast<std::uint8_t>(corner % 3));
  }
  return coded;
}

}  // namespace deltamesh
