// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Between a level and the next coarser one: interpolation P upward, its transpose downward.
#pragma once

#include <span>

#include "base/large_vector.h"
#include "laplacian/multigrid_aggregate.h"
#include "laplacian/multigrid_level.h"
#include "laplacian/multigrid_row.h"

namespace deltamesh::multigrid {

/// Seeds keep their value. Another node's weights are its edge weights summed by the neighbours' aggregates,
/// seeds counted four times; the three largest, scaled to add up to 1. O(n + edges).
LargeVector<Interpolation> make_interpolation(const Level& fine, const Aggregates& aggregates);

/// coarse = P^T fine. O(n).
void restrict_rows(const Level& level, std::span<const Row> fine, std::span<Row> coarse);

/// fine = P coarse. O(n).
void prolong_rows(const Level& level, std::span<const Row> coarse, std::span<Row> fine);

/// fine += P coarse. O(n).
void add_prolonged_rows(const Level& level, std::span<const Row> coarse, std::span<Row> fine);

}  // namespace deltamesh::multigrid
