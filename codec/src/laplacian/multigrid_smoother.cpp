// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid_smoother.h"

#include <algorithm>

#include "laplacian/multigrid_transfer.h"

namespace deltamesh::multigrid {
namespace {

/// Weighted sum of the neighbours' rows.
template <bool kUnitWeights>
Row sum_neighbors(const Level& level, std::span<const Row> u, std::uint32_t node) noexcept {
  Row sum{};
  for (std::uint32_t e = level.offsets[node]; e < level.offsets[node + 1]; ++e) {
    const Row& row = u[level.neighbors[e]];
    if constexpr (kUnitWeights) {
      sum.x += row.x;
      sum.s += row.s;
    } else {
      sum.x += level.weights[e] * row.x;
      sum.s += level.weights[e] * row.s;
    }
  }
  return sum;
}

template <bool kUnitWeights>
void smooth_all(const Level& level, std::span<const Row> b, std::span<Row> u) {
  for (std::uint32_t i = 0; i < u.size(); ++i) {
    const Row sum = sum_neighbors<kUnitWeights>(level, u, i);
    const float inverse = level.inverse_degree[i];
    if (inverse == 0) {
      u[i].s = (level.mass[i] > 0 ? 1 / level.mass[i] : 0.0F) * b[i].x;
      continue;
    }
    u[i].s = inverse * (sum.s + b[i].s);
    u[i].x = inverse * (sum.x + b[i].x - level.mass[i] * u[i].s);
  }
}

template <bool kUnitWeights>
void restrict_all(const Level& level, std::span<const Row> b, std::span<const Row> u, std::span<Row> coarse) {
  std::fill(coarse.begin(), coarse.end(), Row{});
  for (std::uint32_t i = 0; i < u.size(); ++i) {
    const Row sum = sum_neighbors<kUnitWeights>(level, u, i);
    const float degree = level.degree[i];
    const Row residual{b[i].x + sum.x - degree * u[i].x - level.mass[i] * u[i].s,
                       b[i].s + sum.s - degree * u[i].s};
    restrict_row(level.interpolation[i], residual, coarse);
  }
}

}  // namespace

void smooth(const Level& level, std::span<const Row> b, std::span<Row> u) {
  level.has_unit_weights() ? smooth_all<true>(level, b, u) : smooth_all<false>(level, b, u);
}

void restrict_residual(const Level& level, std::span<const Row> b, std::span<const Row> u,
                       std::span<Row> coarse) {
  level.has_unit_weights() ? restrict_all<true>(level, b, u, coarse)
                           : restrict_all<false>(level, b, u, coarse);
}

}  // namespace deltamesh::multigrid
