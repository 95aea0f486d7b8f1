// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The highpass decoder's least-squares problem
//   x = argmin ||L x - delta||^2 + w^2 sum_a ||x_a - c_a||^2,   L = I - D^-1 A,   w = 1,
// one right-hand side per axis, behind an interface that a factorisation and an iteration can both serve.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "base/large_vector.h"
#include "base/vec3.h"
#include "deltamesh/result.h"
#include "laplacian/operator/delta_view.h"
#include "topology/adjacency.h"

namespace deltamesh {

class ThreadTeam;

/// Set up once for a graph and its anchors, then solved for any right-hand sides.
class LeastSquaresSolver {
 public:
  LeastSquaresSolver() = default;
  LeastSquaresSolver(const LeastSquaresSolver&) = delete;
  LeastSquaresSolver& operator=(const LeastSquaresSolver&) = delete;
  virtual ~LeastSquaresSolver() = default;

  /// `deltas`: n; `anchor_positions`: one per anchor, in the order of setup; `x`: n, overwritten.
  /// Errors: kInvalidStream where the system is numerically singular or its solution out of reach.
  /// `cycles`: 0 for as many as the solution takes; else what so many planned cycles make of it [DELT-7],
  /// for encoders: kInvalidStream where these leave the range of 32 bits. Solvers without cycles take no
  /// notice, and give another answer then.
  virtual Result<void> solve(const DeltaView& deltas, std::span<const Vec3> anchor_positions, int cycles,
                             std::span<Vec3> x) = 0;

  Result<void> solve(const DeltaView& deltas, std::span<const Vec3> anchor_positions, std::span<Vec3> x) {
    return solve(deltas, anchor_positions, 0, x);
  }

  /// The same for decoders, which do not ask about that range: n rows, in memory of `size` rows, n or more,
  /// the others not initialised. Where that can be done, the memory is taken after what was set up has been
  /// given back: the solver is of no use any more.
  virtual Result<LargeVector<Vec3>> solve_last(const DeltaView& deltas,
                                               std::span<const Vec3> anchor_positions, int cycles,
                                               std::size_t size);

  /// What solve() for so many cycles would set up first.
  virtual void set_up(int /*cycles*/) {}
};

/// Sparse Cholesky of the normal equations: exact up to rounding; the reference. Time and memory grow faster
/// than n. `graph` must outlive the solver; every component has an anchor; `anchors` distinct vertices.
/// Errors: kInvalidStream where the factorisation fails.
Result<std::unique_ptr<LeastSquaresSolver>> make_direct_solver(const Adjacency& graph,
                                                               std::span<const std::uint32_t> anchors);

/// Multigrid: time and memory linear in n; the error that remains is a few percent of what quantisation
/// leaves. Every vertex has neighbours, otherwise same preconditions and errors as above; kInvalidStream also
/// for cycles on a graph that has one level [DELT-7].
Result<std::unique_ptr<LeastSquaresSolver>> make_multigrid_solver(const Adjacency& graph,
                                                                  std::span<const std::uint32_t> anchors);

/// The same where the graph's components are known already. Planned cycles work on the threads of `team`,
/// which must outlive the solver; null: on that of the caller.
Result<std::unique_ptr<LeastSquaresSolver>> make_solver_for_components(const Adjacency& graph,
                                                                       Components components,
                                                                       std::span<const std::uint32_t> anchors,
                                                                       ThreadTeam* team = nullptr);

}  // namespace deltamesh
