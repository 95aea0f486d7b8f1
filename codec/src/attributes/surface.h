// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The mesh as coders of attributes may use it: faces, which vertices share a position, and the decoded
// positions if every decoder gets the same bits.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "attributes/surface_order.h"
#include "base/numbers/vec3.h"
#include "grid/known/vertex.h"
#include "positions/surroundings.h"
#include "topology/adjacency.h"

namespace deltamesh {

/// Does not own the arrays, which must outlive it. Not for several threads at once.
class AttributeSurface {
 public:
  /// `triangles`: m x 3 indices below `vertex_count`. `geometric`: geometric vertex of every vertex, n, or
  /// empty where each is its own. `positions`: n x 3 decoded floats, model units, or empty where decoders may
  /// differ in their last bits (highpass geometry) [ATTR-10]. `open_edges`: as build_adjacency() asks for;
  /// null: not known. `graph`: graph(), where it is there already.
  AttributeSurface(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count,
                   std::span<const std::uint32_t> geometric = {}, std::span<const float> positions = {},
                   const LargeVector<DirectedEdge>* open_edges = nullptr, std::optional<Adjacency> graph = {})
      : triangles_(triangles),
        vertex_count_(vertex_count),
        geometric_(geometric),
        positions_(positions),
        open_edges_(open_edges),
        graph_(std::move(graph)) {}

  std::span<const std::uint32_t> triangles() const noexcept { return triangles_; }
  std::uint32_t vertex_count() const noexcept { return vertex_count_; }
  std::uint32_t geometric_of(std::uint32_t vertex) const noexcept {
    return geometric_.empty() ? vertex : geometric_[vertex];
  }
  /// The geometric vertex of every vertex; empty if every vertex is its own.
  std::span<const std::uint32_t> geometric() const noexcept { return geometric_; }
  /// The vertex after the last copy of `vertex`; its copies are consecutive.
  std::uint32_t copies_end(std::uint32_t vertex) const noexcept {
    std::uint32_t end = vertex + 1;
    while (end < vertex_count_ && geometric_of(end) == geometric_of(vertex)) ++end;
    return end;
  }
  /// `known`: for the geometric vertices the known one on the same edge, or kNoKnownVertex; or empty. Must
  /// outlive the surface.
  void set_known(std::span<const std::uint32_t> known) noexcept { known_ = known; }
  bool has_known() const noexcept { return !known_.empty(); }
  /// Precondition: has_known().
  std::uint32_t known_of(std::uint32_t vertex) const noexcept { return known_[geometric_of(vertex)]; }
  bool has_positions() const noexcept { return !positions_.empty(); }
  /// n x 3, or empty.
  std::span<const float> positions() const noexcept { return positions_; }
  Vec3 position(std::uint32_t vertex) const noexcept {
    return widen(positions_.data() + std::size_t{3} * vertex);
  }

  /// The mesh's graph; copies of a geometric vertex are separate vertices. Computed on first use, O(m).
  const Adjacency& graph() const {
    if (!graph_)
      graph_ = open_edges_ != nullptr ? build_adjacency(triangles_, *open_edges_, vertex_count_)
                                      : build_adjacency(triangles_, vertex_count_);
    return *graph_;
  }
  /// The known faces of the mesh's vertices. Computed on first use, O(n + m).
  const KnownFaces& faces() const {
    if (!faces_) faces_.emplace(FaceList{triangles_, vertex_count_});
    return *faces_;
  }
  /// The known faces of the geometric vertices; geometric() must not be empty. Computed on first use,
  /// O(n + m).
  const KnownFaces& joined_faces() const {
    if (!joined_faces_) {
      std::vector<std::uint32_t> triangles(triangles_.begin(), triangles_.end());
      for (std::uint32_t& vertex : triangles) vertex = geometric_[vertex];
      joined_faces_.emplace(FaceList{triangles, geometric_.back() + 1});
    }
    return *joined_faces_;
  }

  /// The corners at every vertex of the mesh. Computed on first use, O(n + m).
  const VertexCorners& corners() const {
    if (!corners_) corners_.emplace(triangles_, vertex_count_);
    return *corners_;
  }
  /// The order in which attributes predicted from faces are coded. Computed on first use, O(n + m).
  const SurfaceOrder& surface_order() const {
    if (!order_) order_ = make_surface_order(triangles_, vertex_count_, corners());
    return *order_;
  }

 private:
  std::span<const std::uint32_t> triangles_;
  std::uint32_t vertex_count_;
  std::span<const std::uint32_t> geometric_;
  std::span<const float> positions_;
  std::span<const std::uint32_t> known_;
  const LargeVector<DirectedEdge>* open_edges_;
  mutable std::optional<Adjacency> graph_;
  mutable std::optional<VertexCorners> corners_;
  mutable std::optional<SurfaceOrder> order_;
  mutable std::optional<KnownFaces> faces_;
  mutable std::optional<KnownFaces> joined_faces_;
};

}  // namespace deltamesh
