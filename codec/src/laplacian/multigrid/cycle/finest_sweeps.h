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

/// One Gauss-Seidel sweep per entry of `relaxation`, which is its over-relaxation factor. The first sweep
/// computes `step` from residual(node, row), called once for every node in ascending order; keep(node, step)
/// is called after each step and must apply it before the next residual is asked for.
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
