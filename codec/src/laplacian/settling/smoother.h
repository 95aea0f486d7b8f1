// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Gauss-Seidel on both fields of a level at once, and the residual that it leaves.
#pragma once

#include <span>

#include "laplacian/settling/level.h"
#include "laplacian/settling/row.h"

namespace deltamesh::settling {

/// One sweep in order: at every node first s from K s = b_s, then x from K x + M s = b_x.
/// `u`, `b`: n. O(n + edges).
void smooth(const Level& level, std::span<const Row> b, std::span<Row> u);

/// The same from u = 0, whatever is there: half the work. Not for the finest level.
void smooth_from_zero(const Level& level, std::span<const Row> b, std::span<Row> u);

/// coarse = P^T (b - [K M; 0 K] u) right after smooth_from_zero(): of every equation only what the higher
/// neighbours changed since is left. Half the work again.
void restrict_residual_from_zero(const Level& level, std::span<const Row> b, std::span<const Row> u,
                                 std::span<Row> coarse);

/// coarse = P^T (b - [K M; 0 K] u). O(n + edges).
void restrict_residual(const Level& level, std::span<const Row> b, std::span<const Row> u,
                       std::span<Row> coarse);

}  // namespace deltamesh::settling
