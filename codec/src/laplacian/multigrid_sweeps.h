// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Over-relaxed Gauss-Seidel sweeps on K e = r from zero, and the residual that they leave. A sweep's step
// obeys the equations that e does, with r = 0: neither r nor the first residual is needed again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "laplacian/multigrid_level.h"
#include "laplacian/multigrid_row.h"

namespace deltamesh::multigrid {

/// So many sweeps, each over-relaxed as `relaxation` says: `step` of the first from `residual(node, row)`
/// and, on the rim, `outer_residual(node, row)`, asked for once for every node in the order of the level's
/// chunks, which know what keep(node, step) was told before. `step` of a node without edges, which has none,
/// is its residual.
template <class AnyEdges, class Residual, class OuterResidual, class Keep>
void sweep(const Level& level, const AnyEdges& edges, std::span<const float> relaxation,
           const Residual& residual, const OuterResidual& outer_residual, std::span<Float4> step,
           const Keep& keep) {
  const auto start = [&, by = relaxation[0]](const auto& first_residual) {
    return [&, by](std::uint32_t i) {
      edges.with_row(i, [&](const auto& row) {
        const Float4 r = first_residual(i, row);
        const float inverse = row.inverse_degree();
        const Float4 move = by * inverse * r;
        step[i] = inverse > 0 ? move : r;
        keep(i, move);
      });
    };
  };
  level.chunks.visit(start(residual), start(outer_residual));
  for (std::size_t s = 1; s < relaxation.size(); ++s) {
    const float by = relaxation[s];
    const float own = (1 / relaxation[s - 1] - 1) * by;
    level.chunks.visit([&](std::uint32_t i) {
      edges.with_row(i, [&](const auto& row) {
        const float inverse = row.inverse_degree();
        if (inverse == 0) return;
        step[i] = row.add_scaled(step.data(), own * step[i], by * inverse);
        keep(i, step[i]);
      });
    });
  }
}

/// Gives take(node, residual) what all sweeps leave, in parts that add up; `relaxation`: of the last.
template <class AnyEdges, class Take>
void take_residuals(const Level& level, const AnyEdges& edges, float relaxation, std::span<const Float4> step,
                    const Take& take) {
  const float own = 1 / relaxation - 1;
  const auto inner = [&](std::uint32_t i) {
    edges.with_row(i, [&](const auto& row) {
      const float degree = row.degree();
      take(i, degree > 0 ? row.upper(step.data()) + own * degree * step[i] : step[i]);
    });
  };
  // Those on the rim came after the others, which have heard of higher ones only.
  const auto outer = [&](std::uint32_t i) {
    Float4 sum = own * edges.degree(i) * step[i];
    edges.visit(i, [&](std::uint32_t neighbor, float weight) {
      if (neighbor < i) return;
      if (level.chunks.is_on_rim[neighbor]) {
        sum += weight * step[neighbor];
      } else {
        take(neighbor, weight * step[i]);
      }
    });
    take(i, sum);
  };
  level.chunks.visit(inner, outer);
}

}  // namespace deltamesh::multigrid
