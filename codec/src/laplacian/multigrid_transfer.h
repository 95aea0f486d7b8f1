// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Between a level and the next coarser one: interpolation P upward, its transpose downward.
#pragma once

#include <span>

#include "base/large_vector.h"
#include "laplacian/multigrid_aggregate.h"
#include "laplacian/multigrid_level.h"

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

/// One node's value.
inline Row interpolate(const Interpolation& p, std::span<const Row> coarse) noexcept {
  const Row& a = coarse[p.node[0]];
  const Row& b = coarse[p.node[1]];
  const Row& c = coarse[p.node[2]];
  return {p.weight[0] * a.x + p.weight[1] * b.x + p.weight[2] * c.x,
          p.weight[0] * a.s + p.weight[1] * b.s + p.weight[2] * c.s};
}

/// One node's share of P^T.
inline void restrict_row(const Interpolation& p, const Row& fine, std::span<Row> coarse) noexcept {
  for (std::size_t k = 0; k < 3; ++k) {
    Row& row = coarse[p.node[k]];
    row.x += p.weight[k] * fine.x;
    row.s += p.weight[k] * fine.s;
  }
}

}  // namespace deltamesh::multigrid
