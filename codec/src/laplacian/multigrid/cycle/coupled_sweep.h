// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Gauss-Seidel on both fields of a coarse level at once, and the residual that it leaves [DELT-7].
#pragma once

#include <span>

#include "laplacian/multigrid/level/level.h"
#include "laplacian/multigrid/level/row.h"

namespace deltamesh::multigrid {

/// One sweep by number: at every node first s from K s = b.s, then x from K x + M s = b.x.
/// `u`, `b`: n. O(n + edges).
void sweep(const Level& level, std::span<const Row> b, std::span<Row> u);

/// The same from u = 0, whatever is there: half the work.
void sweep_from_zero(const Level& level, std::span<const Row> b, std::span<Row> u);

/// coarse = P^T (b - [K M; 0 K] u) right after sweep_from_zero(): of every equation only what the higher
/// neighbours changed since is left. Half the work again.
void restrict_from_zero(const Level& level, std::span<const Row> u, std::span<Row> coarse);

}  // namespace deltamesh::multigrid
