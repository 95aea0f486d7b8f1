// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The rows of a coarse level's graph, as sweeps read them.
#pragma once

#include <cstdint>

#include "base/large_vector.h"
#include "laplacian/settling/level.h"
#include "laplacian/settling/row.h"

namespace deltamesh::settling {

static_assert(kEdgesAtOnce == 2);

/// Weighted sums over the neighbours of a node of a coarse level. Adding up is in an order that lets
/// processors do much at once.
class Edges {
 private:
  struct At {
    const Float4* values;
    Float4 operator()(std::uint32_t node) const noexcept { return values[node]; }
  };

 public:
  explicit Edges(const Level& level) noexcept
      : offsets_(level.offsets.data()),
        middle_(level.middle.data()),
        neighbors_(level.neighbors.data()),
        weights_(level.weights.data()),
        degree_(level.degree.data()),
        inverse_degree_(level.inverse_degree.data()) {}

  float degree(std::uint32_t node) const noexcept { return degree_[node]; }
  float inverse_degree(std::uint32_t node) const noexcept { return inverse_degree_[node]; }

  /// `sum` and what lower neighbours add.
  Float4 add_lower(std::uint32_t node, const Float4* values, Float4 sum) const noexcept {
    return add_pairs(offsets_[node], middle_[node], At{values}, sum);
  }

  /// `sum` and the x of all neighbours.
  Float4 add_x(std::uint32_t node, const Row* rows, Float4 sum) const noexcept {
    return add_pairs(
        offsets_[node], offsets_[node + 1], [=](std::uint32_t other) { return rows[other].x; }, sum);
  }

  /// `sum` and what all neighbours add.
  Float4 add_all(std::uint32_t node, const Float4* values, Float4 sum) const noexcept {
    return add_pairs(offsets_[node], offsets_[node + 1], At{values}, sum);
  }

  /// `first` and value(neighbour), weighted, for the edges from `begin` to `end`, one half of a row or both.
  template <class Value, class Sum>
  Sum add_pairs(std::uint32_t begin, std::uint32_t end, const Value& value, const Sum& first) const noexcept {
    Sum sum = first;
    for (std::uint32_t e = begin; e < end; e += kEdgesAtOnce) sum += term(e, value) + term(e + 1, value);
    return sum;
  }

  /// The neighbours of one node.
  class OfNode {
   public:
    OfNode(const Edges& edges, std::uint32_t node) noexcept : edges_(edges), node_(node) {}

    float degree() const noexcept { return edges_.degree(node_); }
    float inverse_degree() const noexcept { return edges_.inverse_degree(node_); }

    /// `first` and `factor` times what all neighbours add up to.
    Float4 add_scaled(const Float4* values, Float4 first, float factor) const noexcept {
      return first + factor * edges_.add_all(node_, values, Float4{});
    }

    /// What higher neighbours add up to.
    Float4 upper(const Float4* values) const noexcept {
      return edges_.add_pairs(edges_.middle_[node_], edges_.offsets_[node_ + 1], At{values}, Float4{});
    }

   private:
    const Edges& edges_;
    std::uint32_t node_;
  };

  /// each(row) of `node`.
  template <class Each>
  void with_row(std::uint32_t node, const Each& each) const {
    each(OfNode(*this, node));
  }

  /// Calls each(neighbour, weight) for all of them.
  template <class Each>
  void visit(std::uint32_t node, const Each& each) const {
    const std::uint32_t end = offsets_[node + 1];
    for (std::uint32_t e = offsets_[node]; e < end; ++e) each(neighbors_[e], weights_[e]);
  }

 private:
  template <class Value>
  auto term(std::uint32_t edge, const Value& value) const noexcept {
    return weights_[edge] * value(neighbors_[edge]);
  }

  const std::uint32_t* offsets_;
  const std::uint32_t* middle_;
  const std::uint32_t* neighbors_;
  const float* weights_;
  const float* degree_;
  const float* inverse_degree_;
};

/// A node's row of K times `values`, floats or doubles; on the finest level too.
template <class Four>
Four apply_k(const Level& level, const LargeVector<Four>& values, std::uint32_t node) noexcept {
  const Four own = level.degree[node] * values[node];
  const std::uint32_t begin = level.offsets[node];
  const std::uint32_t end = level.offsets[node + 1];
  const auto value = [&](std::uint32_t other) { return values[other]; };
  if (!level.has_unit_weights()) return own - Edges(level).add_pairs(begin, end, value, Four{});
  Four sum{};
  for (std::uint32_t e = begin; e < end; ++e) sum += values[level.neighbors[e]];
  return own - sum;
}

}  // namespace deltamesh::settling
