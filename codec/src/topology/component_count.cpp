// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "topology/component_count.h"

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace deltamesh {
namespace {

/// Disjoint sets; the smallest member stands for its set.
class Sets {
 public:
  explicit Sets(std::uint32_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }

  /// Returns whether the two were apart.
  bool unite(std::uint32_t a, std::uint32_t b) noexcept {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    if (a > b) std::swap(a, b);
    parent_[b] = a;
    return true;
  }

 private:
  std::uint32_t find(std::uint32_t v) noexcept {
    while (parent_[v] != v) {
      parent_[v] = parent_[parent_[v]];
      v = parent_[v];
    }
    return v;
  }

  std::vector<std::uint32_t> parent_;
};

}  // namespace

std::uint32_t count_components(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count) {
  Sets sets(vertex_count);
  std::uint32_t count = vertex_count;
  for (std::size_t f = 0; f < triangles.size(); f += 3) {
    count -= sets.unite(triangles[f], triangles[f + 1]) ? 1 : 0;
    count -= sets.unite(triangles[f + 1], triangles[f + 2]) ? 1 : 0;
  }
  return count;
}

}  // namespace deltamesh
