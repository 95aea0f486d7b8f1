// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/solver.h"

#include "base/try.h"

namespace deltamesh {

Result<LargeVector<Vec3>> LeastSquaresSolver::solve_last(const DeltaView& deltas,
                                                         std::span<const Vec3> anchor_positions, int cycles,
                                                         std::size_t size) {
  LargeVector<Vec3> x(size);
  DELTAMESH_CHECK(solve(deltas, anchor_positions, cycles, std::span(x).first(deltas.size())));
  return x;
}

}  // namespace deltamesh
