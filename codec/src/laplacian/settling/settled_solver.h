// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The least-squares solution [DELT-4]: cycles in floats around a solution in doubles, with a watch on every
// component, and a factorisation or conjugate gradients for those that do not settle.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "deltamesh/result.h"
#include "laplacian/operator/delta_view.h"
#include "laplacian/settling/small_components.h"
#include "topology/adjacency.h"

namespace deltamesh::settling {

class GroupSolver;

class SettledSolver {
 public:
  /// `components`: of `graph`, which must outlive this; at least one anchor in each. O(n + edges).
  SettledSolver(const Adjacency& graph, Components components, std::span<const std::uint32_t> anchors);
  ~SettledSolver();
  SettledSolver(const SettledSolver&) = delete;
  SettledSolver& operator=(const SettledSolver&) = delete;

  /// `x`: n, overwritten. The error that remains is a few percent of what quantisation leaves. O(n + edges).
  /// Errors: kInvalidStream [DELT-4] where the solution is out of reach.
  Result<void> solve(const DeltaView& deltas, std::span<const Vec3> anchor_positions, std::span<Vec3> x);

 private:
  SmallComponents small_;
  std::vector<std::unique_ptr<GroupSolver>> groups_;
};

}  // namespace deltamesh::settling
