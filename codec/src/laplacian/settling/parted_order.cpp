// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/parted_order.h"

#include <algorithm>
#include <numeric>

namespace deltamesh::settling {
namespace {

/// Fewer are done sooner than another thread has begun. Part of what a stream means.
constexpr std::uint32_t kFewestOrdered = 2048;

/// Whether `is(neighbor)` of one of them. Edges without weight are not any.
template <class Is>
bool has_neighbor(const Level& level, std::uint32_t node, const Is& is) {
  for (std::uint32_t e = level.offsets[node]; e < level.offsets[node + 1]; ++e) {
    if (level.weight(e) != 0 && is(level.neighbors[e])) return true;
  }
  return false;
}

}  // namespace

PartedOrder order_in_parts(const Level& level) {
  const std::uint32_t n = level.node_count();
  PartedOrder order;
  order.nodes.resize(n);
  std::iota(order.nodes.begin(), order.nodes.end(), 0U);
  if (n < kFewestOrdered) return order;
  order.second = n / 2;
  std::vector<bool> is_near(n);  // or in the first part
  for (std::uint32_t i = 0; i < n; ++i)
    is_near[i] =
        i < order.second || has_neighbor(level, i, [&](std::uint32_t j) { return j < order.second; });
  const auto stays = [&](std::uint32_t i) {
    return !is_near[i] && !has_neighbor(level, i, [&](std::uint32_t j) { return is_near[j]; });
  };
  const auto rest = std::stable_partition(order.nodes.begin() + order.second, order.nodes.end(), stays);
  order.rest = static_cast<std::uint32_t>(rest - order.nodes.begin());
  return order;
}

}  // namespace deltamesh::settling
