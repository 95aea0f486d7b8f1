// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/coarsest/narrow_order.h"

#include <algorithm>
#include <cstddef>

namespace deltamesh::multigrid {
namespace {

/// Appends all that can be reached from `first`, nearest first. `is_seen`: n.
void append_reached(const Level& level, std::uint32_t first, std::vector<bool>& is_seen,
                    std::vector<std::uint32_t>& nodes) {
  std::size_t next = nodes.size();
  nodes.push_back(first);
  is_seen[first] = true;
  for (; next < nodes.size(); ++next) {
    const std::uint32_t node = nodes[next];
    for (std::uint32_t e = level.offsets[node]; e < level.offsets[node + 1]; ++e) {
      const std::uint32_t neighbor = level.neighbors[e];
      if (is_seen[neighbor]) continue;
      is_seen[neighbor] = true;
      nodes.push_back(neighbor);
    }
  }
}

}  // namespace

void order_narrowly(const Level& level, std::vector<std::uint32_t>& nodes) {
  nodes.clear();
  std::vector<bool> is_seen(level.node_count());
  for (std::uint32_t node = 0; node < level.node_count(); ++node) {
    if (is_seen[node]) continue;
    // What a walk from anywhere reaches last is at an end.
    const auto begin = static_cast<std::ptrdiff_t>(nodes.size());
    append_reached(level, node, is_seen, nodes);
    const std::uint32_t end = nodes.back();
    for (auto reached = nodes.begin() + begin; reached != nodes.end(); ++reached) is_seen[*reached] = false;
    nodes.resize(static_cast<std::size_t>(begin));
    append_reached(level, end, is_seen, nodes);
  }
  std::reverse(nodes.begin(), nodes.end());
}

}  // namespace deltamesh::multigrid
