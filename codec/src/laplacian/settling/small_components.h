// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Components so small that each is solved on its own by a dense factorisation.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "deltamesh/result.h"
#include "laplacian/operator/delta_view.h"
#include "topology/adjacency.h"

namespace deltamesh::settling {

/// The components of at most kLargest vertices of a graph, and their anchors.
class SmallComponents {
 public:
  static constexpr std::uint32_t kLargest = 64;

  /// `components`: of `graph`, which must outlive this; `anchors`: distinct vertices. O(n + anchors).
  SmallComponents(const Adjacency& graph, const Components& components,
                  std::span<const std::uint32_t> anchors);

  bool empty() const noexcept { return first_vertex_.size() == 1; }

  /// Solves each as LeastSquaresSolver::solve would, exact up to the rounding of doubles; x of all other
  /// vertices stays. Cost per vertex at most the square of kLargest; no memory. Errors: kInvalidStream
  /// [DELT-4] where a component has no anchor.
  Result<void> solve(const DeltaView& deltas, std::span<const Vec3> anchor_positions,
                     std::span<Vec3> x) const;

 private:
  /// False where a component has no anchor.
  bool solve_range(std::uint32_t begin, std::uint32_t end, const DeltaView& deltas,
                   std::span<const Vec3> anchor_positions, std::span<Vec3> x) const;
  std::span<const std::uint32_t> vertices_of(std::size_t c) const noexcept {
    return std::span(vertices_).subspan(first_vertex_[c], first_vertex_[c + 1] - first_vertex_[c]);
  }
  std::span<const std::uint32_t> anchors_of(std::size_t c) const noexcept {
    return std::span(anchors_).subspan(first_anchor_[c], first_anchor_[c + 1] - first_anchor_[c]);
  }

  const Adjacency& graph_;
  std::vector<std::uint32_t> anchor_vertex_;  ///< vertex of every anchor
  std::vector<std::uint32_t> vertices_;       ///< of the small components, ascending in each
  std::vector<std::uint32_t> anchors_;        ///< numbers of the anchors on them
  std::vector<std::uint32_t> first_vertex_;   ///< where each begins in `vertices_`, and the end
  std::vector<std::uint32_t> first_anchor_;   ///< likewise in `anchors_`
};

}  // namespace deltamesh::settling
