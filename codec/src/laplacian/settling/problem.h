// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The least-squares problem [DELT-4], whole or of some components.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "base/numbers/vec3.h"
#include "laplacian/operator/delta_view.h"
#include "topology/adjacency.h"
#include "topology/vertex_subset.h"

namespace deltamesh::settling {

/// Owns nothing.
struct Problem {
  const Adjacency& graph;                  ///< n vertices, which have neighbours
  const Components& components;            ///< of `graph`, at least one
  std::span<const std::uint32_t> anchors;  ///< ascending, at least one in each component
  DeltaView deltas;                        ///< n
  std::span<const Vec3> targets;           ///< one per anchor
  /// Quantisation step of the deltas; infinite where it is not known.
  double step = deltas.has_symbols() ? deltas.scale().step : std::numeric_limits<double>::infinity();
};

/// Some components as a problem of their own.
class PartialProblem {
 public:
  /// `vertices`: whole components. O(their size), and O(log n) for each run.
  PartialProblem(const Problem& whole, VertexSubset vertices);
  PartialProblem(const PartialProblem&) = delete;
  PartialProblem& operator=(const PartialProblem&) = delete;

  /// Refers to this.
  Problem problem() const noexcept { return {graph_, components_, anchors_, deltas_, targets_, step_}; }

  const VertexSubset& vertices() const noexcept { return vertices_; }

 private:
  VertexSubset vertices_;
  Adjacency graph_;
  Components components_;
  std::vector<std::uint32_t> anchors_;
  std::vector<Vec3> deltas_;
  std::vector<Vec3> targets_;
  double step_;
};

}  // namespace deltamesh::settling
