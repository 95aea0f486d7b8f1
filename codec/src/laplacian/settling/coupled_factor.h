// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The coupled problem on the finest level, solved by factorisation: for what cycles do not settle.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/memory/large_vector.h"
#include "laplacian/multigrid/cycle/level_solver.h"
#include "laplacian/settling/factor.h"
#include "topology/adjacency.h"

namespace deltamesh::settling {

/// K x + D^2 s = b,  K s - sum_a x_a e_a = t - sum_a g_a e_a: symmetric and quasi-definite with s first, of
/// every vertex s before x. Unlike the normal equations it has no more entries than the graph has edges, hubs
/// or not.
class CoupledFactor {
 public:
  /// Every component must have an anchor. `work_left` and empty results: as SparseFactor::make().
  static std::optional<CoupledFactor> make(const Adjacency& graph, std::span<const std::uint32_t> anchors,
                                           std::uint64_t& work_left);

  /// Right-hand sides and solution.
  multigrid::LevelSolver::Vectors& first() noexcept { return vectors_; }

  /// Computes u and forces from b and gaps of first().
  void solve();

 private:
  std::vector<std::uint32_t> anchors_;
  SparseFactor factor_;
  multigrid::LevelSolver::Vectors vectors_;
  LargeVector<Double4> values_;  ///< 2 n: s and x of each vertex
};

}  // namespace deltamesh::settling
