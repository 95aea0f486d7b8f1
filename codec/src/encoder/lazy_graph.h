// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The graph of the coded mesh, for those stages that need it: a quick encode has none.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "topology/adjacency.h"

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

}  // namespace deltamesh
