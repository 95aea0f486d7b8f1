// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The rows of the finest level, whose weights are all 1, as sweeps read them.
#pragma once

#include <cstdint>

#include "laplacian/multigrid_level.h"
#include "laplacian/multigrid_row.h"

namespace deltamesh::multigrid {

/// What Edges is for other levels. Vertices with six neighbours, which most have, are done without a loop,
/// whose end could not be predicted, and without waiting for one addition after the other.
class UnitEdges {
 public:
  explicit UnitEdges(const Level& level) noexcept
      : offsets_(level.offsets.data()), neighbors_(level.neighbors.data()), node_count_(level.node_count()) {}

  std::uint32_t neighbor_count(std::uint32_t node) const noexcept {
    return offsets_[node + 1] - offsets_[node];
  }
  float degree(std::uint32_t node) const noexcept { return static_cast<float>(neighbor_count(node)); }
  float inverse_degree(std::uint32_t node) const noexcept {
    const float d = degree(node);
    return d > 0 ? 1 / d : 0;
  }

  /// What all neighbours add up to. `values`: floats or whole numbers.
  template <class Four>
  Four sum(std::uint32_t node, const Four* values) const noexcept {
    return sum_of<Four>(node, [=](std::uint32_t other) { return values[other]; });
  }

  /// `first` and `factor` times what all neighbours add up to.
  Float4 add_scaled(std::uint32_t node, const Float4* values, Float4 first, float factor) const noexcept {
    const std::uint32_t* const n = neighbors_ + offsets_[node];
    const auto value = [=](std::uint32_t other) { return values[other]; };
    if (neighbor_count(node) != 6) return first + factor * sum(node, values);
    return (first + factor * all_but_third<Float4>(n, value)) + factor * value(n[2]);
  }

  /// What higher neighbours add up to. `values`: one more than there are nodes, the last being 0.
  Float4 upper(std::uint32_t node, const Float4* values) const noexcept {
    const std::uint32_t none = node_count_;
    return sum_of<Float4>(node, [=](std::uint32_t other) { return values[other > node ? other : none]; });
  }

  /// Calls each(neighbour, weight) for all of them.
  template <class Each>
  void visit(std::uint32_t node, const Each& each) const {
    for (std::uint32_t e = offsets_[node]; e < offsets_[node + 1]; ++e) each(neighbors_[e], 1.0F);
  }

 private:
  /// Of six neighbours in ascending order, half of which are mostly lower ones: then the third is the one
  /// that was done last, and nothing but its own term waits for it.
  template <class Four, class Value>
  static Four all_but_third(const std::uint32_t* n, const Value& value) noexcept {
    return (value(n[0]) + value(n[1])) + (value(n[3]) + value(n[4])) + value(n[5]);
  }

  template <class Four, class Value>
  Four sum_of(std::uint32_t node, const Value& value) const noexcept {
    const std::uint32_t* const n = neighbors_ + offsets_[node];
    const std::uint32_t count = neighbor_count(node);
    if (count == 6) return all_but_third<Four>(n, value) + value(n[2]);
    Four sum{};
    for (std::uint32_t k = 0; k < count; ++k) sum += value(n[k]);
    return sum;
  }

  const std::uint32_t* offsets_;
  const std::uint32_t* neighbors_;
  std::uint32_t node_count_;
};

}  // namespace deltamesh::multigrid
