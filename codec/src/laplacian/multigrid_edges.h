// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The rows of a level's graph, as sweeps read them.
#pragma once

#include <cstdint>

#include "laplacian/multigrid_level.h"
#include "laplacian/multigrid_row.h"

namespace deltamesh::multigrid {

static_assert(kEdgesAtOnce == 4);

/// Weighted sums over the neighbours of a node. Adding up is in an order that lets processors do much at
/// once.
template <bool kUnitWeights>
class Edges {
 public:
  explicit Edges(const Level& level) noexcept
      : offsets_(level.offsets.data()),
        middle_(level.middle.data()),
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

  /// `sum` and what lower neighbours add. Not on the finest level.
  Float4 add_lower(std::uint32_t node, const Float4* values, Float4 sum) const noexcept {
    return add_fours(offsets_[node], middle_[node], at(values), sum);
  }

  /// `sum` and the x of all neighbours. Not on the finest level.
  Float4 add_x(std::uint32_t node, const Row* rows, Float4 sum) const noexcept {
    return add_fours(
        offsets_[node], offsets_[node + 1], [=](std::uint32_t other) { return rows[other].x; }, sum);
  }

  /// What higher neighbours add up to.
  Float4 upper(std::uint32_t node, const Float4* values) const noexcept {
    Float4 sum{};
    const std::uint32_t begin = offsets_[node];
    if constexpr (!kUnitWeights) return add_fours(middle_[node], offsets_[node + 1], at(values), sum);
    for (std::uint32_t e = offsets_[node + 1]; e > begin && neighbors_[e - 1] > node; --e)
      sum += values[neighbors_[e - 1]];
    return sum;
  }

  /// `sum` and what all neighbours add.
  Float4 add_all(std::uint32_t node, const Float4* values, Float4 sum) const noexcept {
    const std::uint32_t end = offsets_[node + 1];
    if constexpr (!kUnitWeights) return add_fours(offsets_[node], end, at(values), sum);
    for (std::uint32_t e = offsets_[node]; e < end; ++e) sum += values[neighbors_[e]];
    return sum;
  }

  /// `first` and value(neighbour), weighted, for the edges from `begin` to `end`, one half of a row or both.
  template <class Value, class Sum>
  Sum add_fours(std::uint32_t begin, std::uint32_t end, const Value& value, const Sum& first) const noexcept {
    Sum sum = first;
    for (std::uint32_t e = begin; e < end; e += kEdgesAtOnce)
      sum += (term(e, value) + term(e + 1, value)) + (term(e + 2, value) + term(e + 3, value));
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
  template <class Value>
  auto term(std::uint32_t edge, const Value& value) const noexcept {
    return weights_[edge] * value(neighbors_[edge]);
  }

  static auto at(const Float4* values) noexcept {
    return [=](std::uint32_t node) { return values[node]; };
  }

  const std::uint32_t* offsets_;
  const std::uint32_t* middle_;
  const std::uint32_t* neighbors_;
  const float* weights_;
  const float* degree_;
  const float* inverse_degree_;
};

}  // namespace deltamesh::multigrid
