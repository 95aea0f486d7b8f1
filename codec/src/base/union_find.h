// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Disjoint sets of numbers that become one by and by.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace deltamesh {

/// Sets of the numbers 0 to n - 1, at first each by itself. O(log n) a call in the mean.
class UnionFind {
 public:
  explicit UnionFind(std::size_t count) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), std::size_t{0});
  }

  /// The lowest number of the set of i.
  std::size_t find(std::size_t i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }

  /// Returns whether they were of different sets.
  bool unite(std::size_t a, std::size_t b) {
    a = find(a);
    b = find(b);
    parents_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<std::size_t> parents_;
};

}  // namespace deltamesh
