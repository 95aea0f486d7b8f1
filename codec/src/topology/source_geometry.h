// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Positions and faces of the welded mesh in coding order, as geometry coders get them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/numbers/vec3.h"
#include "topology/adjacency.h"
#include "topology/extent.h"
#include "topology/mesh_edges.h"

namespace deltamesh {

/// Made when first asked for. Not for several threads at once.
class LazyGraph {
 public:
  /// `triangles`: over geometric vertices, coding order; they must outlive this.
  LazyGraph(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count) noexcept
      : triangles_(triangles), vertex_count_(vertex_count) {}

  const Adjacency& graph() const {
    if (!graph_) graph_ = build_adjacency(triangles_, vertex_count_);
    return *graph_;
  }
  const Components& components() const {
    if (!components_) components_ = find_components(graph());
    return *components_;
  }

 private:
  std::span<const std::uint32_t> triangles_;
  std::uint32_t vertex_count_;
  mutable std::optional<Adjacency> graph_;
  mutable std::optional<Components> components_;
};

/// Not for several threads at once.
struct SourceGeometry {
  /// `mesh_edges`: of all faces, whose triangles must outlive this.
  SourceGeometry(std::vector<Vec3> vertex_positions, MeshEdges mesh_edges)
      : positions(std::move(vertex_positions)),
        box(Box::around(positions)),
        extent(extent_of(positions, box)),
        triangles(mesh_edges.triangles),
        graph(triangles, static_cast<std::uint32_t>(positions.size())),
        edges(std::move(mesh_edges)) {}

  std::vector<Vec3> positions;               ///< n, relative to the mesh's origin
  Box box;                                   ///< of `positions`; empty if there are none
  Extent extent;                             ///< of the mesh without stray vertices
  std::span<const std::uint32_t> triangles;  ///< m x 3
  LazyGraph graph;                           ///< of `triangles`
  MeshEdges edges;                           ///< likewise
};

}  // namespace deltamesh
