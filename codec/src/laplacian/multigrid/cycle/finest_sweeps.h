// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Over-relaxed Gauss-Seidel sweeps of the finest level, and the residual that they leave [DELT-7]. A sweep's
// step obeys the same equations as the correction that it is part of, with no right-hand side: neither that
// nor the first residual is needed again.
#pragma once

#include <cstdint>
#include <span>

#include "laplacian/multigrid/level/row.h"
#include "laplacian/multigrid/level/unit_edges.h"

namespace deltamesh::multigrid {

/// So many sweeps, each over-relaxed as `relaxation` says: `step` of the first from `residual(node, row)`,
/// asked for once for every node, by number, which knows what keep(node, step) was told before.
template <class Residual, class Keep>
void sweep(const UnitEdges& edges, std::span<const float> relaxation, const Residual& residual,
           std::span<Float4> step, const Keep& keep) {
  for (std::uint32_t i = 0; i < edges.node_count(); ++i) {
    edges.with_row(i, [&](const auto& row) {
      step[i] = relaxation[0] * row.inverse_degree() * residual(i, row);
      keep(i, step[i]);
    });
  }
  for (std::size_t s = 1; s < relaxation.size(); ++s) {
    const float by = relaxation[s];
    const float own = (1 / relaxation[s - 1] - 1) * by;
    for (std::uint32_t i = 0; i < edges.node_count(); ++i) {
      edges.with_row(i, [&](const auto& row) {
        step[i] = row.add_scaled(step.data(), own * step[i], by * row.inverse_degree());
        keep(i, step[i]);
      });
    }
  }
}

/// Gives take(node, residual) what all sweeps leave, the last of them not over-relaxed.
template <class Take>
void take_residuals(const UnitEdges& edges, std::span<const Float4> step, const Take& take) {
  for (std::uint32_t i = 0; i < edges.node_count(); ++i)
    edges.with_row(i, [&](const auto& row) { take(i, row.upper(step.data())); });
}

}  // namespace deltamesh::multigrid
