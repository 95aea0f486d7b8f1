// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Gauss-Seidel on K e = r from zero, forward and then backward, and the residual that they leave, with every
// edge visited three times in place of six (Eisenstat, Efficient implementation of a class of preconditioned
// conjugate gradient methods, 1981).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "laplacian/multigrid_level.h"
#include "laplacian/multigrid_row.h"

namespace deltamesh::multigrid {

/// The edges of a node that lead to lower ones come first.
template <bool kUnitWeights>
class Edges {
 public:
  explicit Edges(const Level& level) noexcept
      : offsets_(level.offsets.data()), neighbors_(level.neighbors.data()), weights_(level.weights.data()) {}

  /// `sum` and the weighted `values` at the lower ends of the edges of `node` that lead to lower nodes.
  Float4 add_lower(std::uint32_t node, const Float4* values, Float4 sum) const noexcept {
    const std::uint32_t end = offsets_[node + 1];
    for (std::uint32_t e = offsets_[node]; e < end && neighbors_[e] < node; ++e) sum += term(e, values);
    return sum;
  }

  /// Likewise of those to higher nodes, from the last on.
  Float4 add_upper(std::uint32_t node, const Float4* values, Float4 sum) const noexcept {
    const std::uint32_t begin = offsets_[node];
    for (std::uint32_t e = offsets_[node + 1]; e > begin && neighbors_[e - 1] > node; --e)
      sum += term(e - 1, values);
    return sum;
  }

 private:
  Float4 term(std::uint32_t edge, const Float4* values) const noexcept {
    if constexpr (kUnitWeights) return values[neighbors_[edge]];
    return weights_[edge] * values[neighbors_[edge]];
  }

  const std::uint32_t* offsets_;
  const std::uint32_t* neighbors_;
  const float* weights_;
};

/// The forward sweep: e from `residual(node)`, asked for once for every node in order. `step` takes the
/// residual of nodes without edges.
template <bool kUnitWeights, class Residual>
void sweep_forward(const Level& level, const Residual& residual, std::span<Float4> e, std::span<Float4> step) {
  const Edges<kUnitWeights> edges(level);
  for (std::uint32_t i = 0; i < e.size(); ++i) {
    const Float4 r = residual(i);
    const float inverse = level.inverse_degree[i];
    e[i] = inverse * edges.add_lower(i, e.data(), r);
    if (inverse == 0) step[i] = r;
  }
}

/// The backward sweep: e, and what it adds to it as `step`.
template <bool kUnitWeights>
void sweep_backward(const Level& level, std::span<Float4> e, std::span<Float4> step) {
  const Edges<kUnitWeights> edges(level);
  for (auto i = static_cast<std::uint32_t>(e.size()); i-- > 0;) {
    const float inverse = level.inverse_degree[i];
    if (inverse == 0) continue;
    step[i] = inverse * edges.add_upper(i, e.data(), Float4{});
    e[i] += step[i];
  }
}

/// Gives take(node, residual) what both sweeps leave: only the steps of lower neighbours came after a node's
/// own equation was solved.
template <bool kUnitWeights, class Take>
void take_residuals(const Level& level, std::span<const Float4> step, const Take& take) {
  const Edges<kUnitWeights> edges(level);
  for (std::uint32_t i = 0; i < step.size(); ++i)
    take(i, edges.add_lower(i, step.data(), level.inverse_degree[i] == 0 ? step[i] : Float4{}));
}

}  // namespace deltamesh::multigrid
