// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Weighted sums over the neighbours of a node of a coarse level.
#pragma once

#include <cstdint>

#include "laplacian/multigrid/level/level.h"
#include "laplacian/multigrid/level/row.h"

namespace deltamesh::multigrid {

class Edges {
 public:
  explicit Edges(const Level& level) noexcept
      : offsets_(level.offsets.data()),
        middle_(level.middle.data()),
        neighbors_(level.neighbors.data()),
        weights_(level.weights.data()) {}

  /// Weighted sum of value(neighbour) over all neighbours, the lower or the higher ones.
  template <class Value>
  auto sum_all(std::uint32_t node, const Value& value) const noexcept {
    return sum(offsets_[node], offsets_[node + 1], value);
  }
  template <class Value>
  auto sum_lower(std::uint32_t node, const Value& value) const noexcept {
    return sum(offsets_[node], middle_[node], value);
  }
  template <class Value>
  auto sum_higher(std::uint32_t node, const Value& value) const noexcept {
    return sum(middle_[node], offsets_[node + 1], value);
  }

 private:
  template <class Value>
  auto sum(std::uint32_t begin, std::uint32_t end, const Value& value) const noexcept {
    decltype(value(0)) result{};
    if ((end - begin) % 2 != 0) {
      result = weights_[begin] * value(neighbors_[begin]);
      ++begin;
    }
    for (; begin < end; begin += 2)  // one addition waits for another only every two edges
      result +=
          weights_[begin] * value(neighbors_[begin]) + weights_[begin + 1] * value(neighbors_[begin + 1]);
    return result;
  }

  const std::uint32_t* offsets_;
  const std::uint32_t* middle_;
  const std::uint32_t* neighbors_;
  const float* weights_;
};

}  // namespace deltamesh::multigrid
