// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The rows of the finest level, whose weights are all 1, as sweeps read them.
#pragma once

#include <cstdint>
#include <type_traits>

#include "base/simd/four_ints.h"
#include "laplacian/multigrid/level/level.h"
#include "laplacian/multigrid/level/row.h"

namespace deltamesh::multigrid {

/// The neighbours of one node. `Count`: of their number, which may be known beforehand.
template <class Count>
class UnitRow {
 public:
  UnitRow(std::uint32_t node, std::uint32_t none, const std::uint32_t* neighbors, Count count) noexcept
      : node_(node), none_(none), neighbors_(neighbors), count_(count) {}

  float degree() const noexcept { return static_cast<float>(count_); }
  float inverse_degree() const noexcept { return 1 / degree(); }

  /// The number of neighbours times `value`.
  FourUnsigned times(FourUnsigned value) const noexcept {
    if constexpr (kIsSix) return (value << 1) + (value << 2);
    return std::uint32_t{count_} * value;
  }

  /// Sum over all neighbours. `values`: floats or integers, by node.
  template <class Four>
  Four sum(const Four* values) const noexcept {
    return sum_of<Four>([=](std::uint32_t other) { return values[other]; });
  }

  /// Sum of value(neighbour) over all neighbours.
  template <class Value>
  Float4 sum_floats(const Value& value) const noexcept {
    return sum_of<Float4>(value);
  }

  /// `first` plus `factor` times the sum over all neighbours.
  Float4 add_scaled(const Float4* values, Float4 first, float factor) const noexcept {
    if constexpr (kIsSix) {
      const auto value = [=](std::uint32_t other) { return values[other]; };
      return (first + factor * all_but_third<Float4>(value)) + factor * value(neighbors_[2]);
    }
    return first + factor * sum(values);
  }

  /// Sum over the higher neighbours. `values`: by node, and a 0 at the end.
  Float4 upper(const Float4* values) const noexcept {
    const auto value = [=, node = node_, none = none_](std::uint32_t other) {
      return values[other > node ? other : none];
    };
    return sum_of<Float4>(value);
  }

 private:
  static constexpr bool kIsSix = !std::is_same_v<Count, std::uint32_t>;

  /// Sum over six ascending neighbours except the third. Usually three of them are lower, so the third is the
  /// node of the preceding step of a sweep, and only its own term waits for that step.
  template <class Four, class Value>
  Four all_but_third(const Value& value) const noexcept {
    const std::uint32_t* const n = neighbors_;
    return (value(n[0]) + value(n[1])) + (value(n[3]) + value(n[4])) + value(n[5]);
  }

  template <class Four, class Value>
  Four sum_of(const Value& value) const noexcept {
    if constexpr (kIsSix) return all_but_third<Four>(value) + value(neighbors_[2]);
    Four sum{};
    for (std::uint32_t k = 0; k < count_; ++k) sum += value(neighbors_[k]);
    return sum;
  }

  std::uint32_t node_;
  std::uint32_t none_;
  const std::uint32_t* neighbors_;
  [[no_unique_address]] Count count_;
};

/// The counterpart of Edges for the finest level. Every node must have neighbours.
class UnitEdges {
 public:
  explicit UnitEdges(const Level& level) noexcept
      : offsets_(level.offsets.data()), neighbors_(level.neighbors.data()), node_count_(level.node_count()) {}

  /// each(row) of `node`. Six neighbours, which most have, make a row of its own kind: without loops, whose
  /// end could not be predicted, and without waiting for one addition after the other.
  template <class Each>
  [[gnu::always_inline]] void with_row(std::uint32_t node, const Each& each) const {
    using Six = std::integral_constant<std::uint32_t, 6>;
    const std::uint32_t* const neighbors = neighbors_ + offsets_[node];
    const std::uint32_t count = offsets_[node + 1] - offsets_[node];
    if (count == Six::value) {
      each(UnitRow<Six>(node, node_count_, neighbors, {}));
    } else {
      each(UnitRow<std::uint32_t>(node, node_count_, neighbors, count));
    }
  }

  std::uint32_t node_count() const noexcept { return node_count_; }

 private:
  const std::uint32_t* offsets_;
  const std::uint32_t* neighbors_;
  std::uint32_t node_count_;
};

}  // namespace deltamesh::multigrid
