// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// One solution with as little memory as can be, or as soon as can be: what a decoder needs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/large_vector.h"
#include "base/vec3.h"
#include "deltamesh/result.h"
#include "laplacian/operator/delta_view.h"
#include "topology/adjacency.h"

namespace deltamesh {

class ThreadTeam;

/// All but the deltas.
struct LeastSquaresProblem {
  Adjacency graph{};
  Components components{};               ///< of the graph
  std::vector<std::uint32_t> anchors{};  ///< distinct vertices, ascending; at least one in every component
  std::vector<Vec3> targets{};           ///< of every anchor
  DeltaScale scale{};                    ///< what the deltas' symbols stand for
  int cycles = 0;                        ///< as LeastSquaresSolver::solve
};

/// The deltas' symbols, once; may use the graph.
using ReadSymbols = std::function<Result<SymbolRows>(const Adjacency&)>;

/// What make_multigrid_solver's solver finds, to the last bit. Of `team`, which may be null, one thread reads
/// the symbols while the others set up the levels. Returns n rows in memory of `size`, n or more. Errors:
/// those of `read_symbols`, and as LeastSquaresSolver::solve.
Result<LargeVector<Vec3>> solve_once(LeastSquaresProblem problem, const ReadSymbols& read_symbols,
                                     std::size_t size, ThreadTeam* team);

}  // namespace deltamesh
