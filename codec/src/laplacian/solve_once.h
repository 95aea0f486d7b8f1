// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// One solution with as little memory as can be: what a decoder needs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/large_vector.h"
#include "base/vec3.h"
#include "deltamesh/result.h"
#include "laplacian/delta_view.h"
#include "topology/adjacency.h"

namespace deltamesh {

struct LeastSquaresProblem {
  Adjacency graph{};
  Components components{};               ///< of the graph
  std::vector<std::uint32_t> anchors{};  ///< distinct vertices, ascending; at least one in every component
  SymbolRows symbols{};                  ///< of the deltas
  DeltaScale scale{};                    ///< what they stand for
  std::vector<Vec3> targets{};           ///< of every anchor
  int half_cycles = 0;                   ///< as LeastSquaresSolver::solve
};

/// What make_multigrid_solver's solver finds, to the last bit. Components that take different hierarchies are
/// solved one set after the other, most of them in place. Returns n rows in memory of `size`, n or more.
/// Errors: as LeastSquaresSolver::solve.
Result<LargeVector<Vec3>> solve_once(LeastSquaresProblem problem, std::size_t size);

}  // namespace deltamesh
