// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/operator/hop_density.h"

#include <vector>

namespace deltamesh {

std::uint32_t hop_density(const Adjacency& graph, std::span<const std::uint32_t> anchors) {
  std::vector<std::uint8_t> reached(graph.vertex_count(), 0);
  std::vector<std::uint32_t> ring(anchors.begin(), anchors.end());
  for (const std::uint32_t anchor : ring) reached[anchor] = 1;
  std::vector<std::uint32_t> next;
  for (std::uint32_t hops = 0;; ++hops) {
    next.clear();
    for (const std::uint32_t vertex : ring) {
      for (const std::uint32_t neighbor : graph.of(vertex)) {
        if (reached[neighbor] != 0) continue;
        reached[neighbor] = 1;
        next.push_back(neighbor);
      }
    }
    if (next.empty()) return hops;
    ring.swap(next);
  }
}

}  // namespace deltamesh
