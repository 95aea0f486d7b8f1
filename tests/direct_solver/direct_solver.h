// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The reference solver of tests and benchmarks.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "base/numbers/vec3.h"
#include "laplacian/operator/delta_view.h"
#include "topology/adjacency.h"

namespace deltamesh::test {

/// The problem of LeastSquaresSolver by a sparse factorisation of the normal equations: exact up to rounding.
/// Time and memory grow faster than n. Ends the program where the system is singular, as none with an anchor
/// in every component is.
class DirectSolver {
 public:
  /// `graph` must outlive the solver; every component has an anchor; `anchors`: distinct vertices.
  DirectSolver(const Adjacency& graph, std::span<const std::uint32_t> anchors);
  ~DirectSolver();

  /// `deltas`, `x`: n; `anchor_positions`: one per anchor.
  void solve(const DeltaView& deltas, std::span<const Vec3> anchor_positions, std::span<Vec3> x) const;

 private:
  class Factors;
  std::unique_ptr<const Factors> factors_;
};

}  // namespace deltamesh::test
