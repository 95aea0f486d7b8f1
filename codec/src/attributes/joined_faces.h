// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The faces of a mesh over its geometric vertices [ATTR-58].
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "predictive/surroundings.h"
#include "topology/adjacency.h"

namespace deltamesh {

/// What is asked for is made then, O(n + m) each. Not for several threads at once.
class JoinedFaces {
 public:
  /// `geometric`: of every vertex, not empty, never falling.
  JoinedFaces(std::span<const std::uint32_t> triangles, std::span<const std::uint32_t> geometric)
      : vertex_count_(geometric.back() + 1) {
    triangles_.reserve(triangles.size());
    for (const std::uint32_t vertex : triangles) triangles_.push_back(geometric[vertex]);
  }

  std::uint32_t vertex_count() const noexcept { return vertex_count_; }
  const KnownFaces& faces() const {
    if (!faces_) faces_.emplace(FaceList{triangles_, vertex_count_});
    return *faces_;
  }
  const Adjacency& graph() const {
    if (!graph_) graph_ = build_adjacency(triangles_, vertex_count_);
    return *graph_;
  }

 private:
  std::vector<std::uint32_t> triangles_;  ///< m x 3
  std::uint32_t vertex_count_;
  mutable std::optional<KnownFaces> faces_;
  mutable std::optional<Adjacency> graph_;
};

}  // namespace deltamesh
