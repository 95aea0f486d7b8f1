// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid/cycle/coupled_sweep.h"

#include <algorithm>

#include "laplacian/multigrid/level/edges.h"

namespace deltamesh::multigrid {
namespace {

/// Solves the equations of a node, given what its neighbours add up to.
Row relax(const Level& level, std::uint32_t i, const Row& b, const Row& sum) noexcept {
  const float inverse = level.inverse_degree[i];
  const Float4 s = inverse * (sum.s + b.s);
  return {inverse * (sum.x + b.x - level.mass[i] * s), s};
}

}  // namespace

void sweep(const Level& level, std::span<const Row> b, std::span<Row> u) {
  const Edges edges(level);
  for (std::uint32_t i = 0; i < level.node_count(); ++i) {
    const Row sum = edges.sum_all(i, [&](std::uint32_t other) { return u[other]; });
    u[i] = relax(level, i, b[i], sum);
  }
}

void sweep_from_zero(const Level& level, std::span<const Row> b, std::span<Row> u) {
  const Edges edges(level);
  for (std::uint32_t i = 0; i < level.node_count(); ++i) {
    const Row sum = edges.sum_lower(i, [&](std::uint32_t other) { return u[other]; });
    u[i] = relax(level, i, b[i], sum);
  }
}

void restrict_from_zero(const Level& level, std::span<const Row> u, std::span<Row> coarse) {
  const Edges edges(level);
  std::fill(coarse.begin(), coarse.end(), Row{});
  for (std::uint32_t i = 0; i < level.node_count(); ++i) {
    const Row residual = edges.sum_higher(i, [&](std::uint32_t other) { return u[other]; });
    level.interpolation[i].spread(residual, [&](std::uint32_t node) -> Row& { return coarse[node]; });
  }
}

}  // namespace deltamesh::multigrid
