// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The coupled problem on a coarse level, and the best length of a cycle's solution [DELT-7].
#pragma once

#include <span>

#include "laplacian/multigrid/level/level.h"
#include "laplacian/multigrid/level/row.h"

namespace deltamesh {
class ThreadTeam;
}

namespace deltamesh::multigrid {

/// K x + M s = b.x,  K s - E f = b.s,  x_a - f_a = g_a.
struct CoupledProblem {
  const Level& level;
  std::span<Row> b;          ///< n; after a cycle, b.s with its forces added
  std::span<Row> u;          ///< n: x and s
  std::span<Float4> gaps;    ///< per anchor: g
  std::span<Float4> forces;  ///< per anchor: f
};

/// The length at which the solution that a cycle found makes the least-squares functional smallest, on every
/// axis by itself: the functional cannot rise, however bad the cycle. `image`: n, overwritten with K x + M s
/// and K s; or empty. O(n + edges). Source: Notay, Vassilevski, Recursive Krylov-based multigrid cycles,
/// 2008, with steps that are not made orthogonal.
Float4 best_length(const CoupledProblem& problem, std::span<Row> image);

/// Leaves in `b` and `gaps` what remains to be solved after so much of a cycle's solution. O(n).
void take_off(const CoupledProblem& problem, Float4 length, std::span<const Row> image, ThreadTeam* team);

}  // namespace deltamesh::multigrid
