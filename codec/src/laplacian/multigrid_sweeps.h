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

/// Measured: 1.1 to 1.3 do well, 1 and 1.4 do not.
inline constexpr float kOverRelaxation = 1.2F;

/// Weighted sums over the neighbours of a node, whose edges to lower ones come first.
template <bool kUnitWeights>
class Edges {
 public:
  explicit Edges(const Level& level) noexcept
      : offsets_(level.offsets.data()),
        neighbors_(level.neighbors.data()),
        weights_(level.weights.data()),
        degree_(level.degree.data()),
        inverse_degree_(level.inverse_degree.data()) {}

  /// Level::degree, which need not be stored where weights are 1.
  float degree(std::uint32_t node) const noexcept {
    if constexpr (kUnitWeights) return static_cast<float>(offsets_[node + 1] - offsets_[node]);
    return degree_[node];
  }

  /// Level::inverse_degree; likewise.
  float inverse_degree(std::uint32_t node) const noexcept {
    if constexpr (!kUnitWeights) return inverse_degree_[node];
    const float d = degree(node);
    return d > 0 ? 1 / d : 0;
  }

  /// `sum` and what lower neighbours add.
  Float4 add_lower(std::uint32_t node, const Float4* values, Float4 sum) const noexcept {
    const std::uint32_t end = offsets_[node + 1];
    for (std::uint32_t e = offsets_[node]; e < end && neighbors_[e] < node; ++e) sum += term(e, values);
    return sum;
  }

  /// `sum` and the x of all neighbours.
  Float4 add_x(std::uint32_t node, const Row* rows, Float4 sum) const noexcept {
    const std::uint32_t end = offsets_[node + 1];
    for (std::uint32_t e = offsets_[node]; e < end; ++e) sum += weights_[e] * rows[neighbors_[e]].x;
    return sum;
  }

  /// What higher neighbours add up to, from the last on.
  Float4 upper(std::uint32_t node, const Float4* values) const noexcept {
    Float4 sum{};
    const std::uint32_t begin = offsets_[node];
    for (std::uint32_t e = offsets_[node + 1]; e > begin && neighbors_[e - 1] > node; --e)
      sum += term(e - 1, values);
    return sum;
  }

  /// `sum` and what all neighbours add.
  Float4 add_all(std::uint32_t node, const Float4* values, Float4 sum) const noexcept {
    const std::uint32_t end = offsets_[node + 1];
    for (std::uint32_t e = offsets_[node]; e < end; ++e) sum += term(e, values);
    return sum;
  }

  /// Calls each(neighbour, weight) for all of them.
  template <class Each>
  void visit(std::uint32_t node, const Each& each) const {
    const std::uint32_t end = offsets_[node + 1];
    for (std::uint32_t e = offsets_[node]; e < end; ++e)
      each(neighbors_[e], kUnitWeights ? 1.0F : weights_[e]);
  }

 private:
  Float4 term(std::uint32_t edge, const Float4* values) const noexcept {
    if constexpr (kUnitWeights) return values[neighbors_[edge]];
    return weights_[edge] * values[neighbors_[edge]];
  }

  const std::uint32_t* offsets_;
  const std::uint32_t* neighbors_;
  const float* weights_;
  const float* degree_;
  const float* inverse_degree_;
};

/// The first sweep: `step` from `residual(node)` and, on the rim, `outer_residual(node)`, asked for once for
/// every node in the order of the level's chunks, which know what keep(node, step) was told before. `step` of
/// a node without edges, which has none, is its residual.
template <bool kUnitWeights, class Residual, class OuterResidual, class Keep>
void sweep_first(const Level& level, const Residual& residual, const OuterResidual& outer_residual,
                 std::span<Float4> step, const Keep& keep) {
  const Edges<kUnitWeights> edges(level);
  const auto sweep = [&](std::uint32_t i, Float4 r) {
    const float inverse = edges.inverse_degree(i);
    const Float4 first = kOverRelaxation * inverse * r;
    step[i] = inverse > 0 ? first : r;
    keep(i, first);
  };
  level.chunks.visit([&](std::uint32_t i) { sweep(i, residual(i)); },
                     [&](std::uint32_t i) { sweep(i, outer_residual(i)); });
}

/// A further sweep.
template <bool kUnitWeights, class Keep>
void sweep_again(const Level& level, std::span<Float4> step, const Keep& keep) {
  const Edges<kUnitWeights> edges(level);
  level.chunks.visit([&](std::uint32_t i) {
    const float inverse = edges.inverse_degree(i);
    if (inverse == 0) return;
    step[i] =
        (1 - kOverRelaxation) * step[i] + kOverRelaxation * inverse * edges.add_all(i, step.data(), Float4{});
    keep(i, step[i]);
  });
}

/// Gives take(node, residual) what all sweeps leave, in parts that add up.
template <bool kUnitWeights, class Take>
void take_residuals(const Level& level, std::span<const Float4> step, const Take& take) {
  constexpr float kOwn = 1 / kOverRelaxation - 1;
  const Edges<kUnitWeights> edges(level);
  const auto inner = [&](std::uint32_t i) {
    const float degree = edges.degree(i);
    take(i, degree > 0 ? edges.upper(i, step.data()) + kOwn * degree * step[i] : step[i]);
  };
  // Those on the rim came after the others, which have heard of higher ones only.
  const auto outer = [&](std::uint32_t i) {
    Float4 sum = kOwn * edges.degree(i) * step[i];
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
