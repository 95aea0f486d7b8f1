// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "open_edges.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace deltamesh {

OpenEdges::OpenEdges(std::span<const std::uint32_t> triangles, std::size_t vertex_count)
    : offsets_(vertex_count + 1, 0) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  edges.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::uint32_t a = triangles[i];
    const std::uint32_t b = triangles[i % 3 == 2 ? i - 2 : i + 1];
    if (a != b) edges.push_back({std::min(a, b), std::max(a, b)});
  }
  std::ranges::sort(edges);
  std::vector<std::array<std::uint32_t, 2>> open;  // from either end
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool is_alone =
        (i == 0 || edges[i - 1] != edges[i]) && (i + 1 == edges.size() || edges[i + 1] != edges[i]);
    if (!is_alone) continue;
    open.push_back(edges[i]);
    open.push_back({edges[i][1], edges[i][0]});
  }
  std::ranges::sort(open);
  for (const auto& [from, to] : open) {
    ++offsets_[from + 1];
    ends_.push_back(to);
  }
  for (std::size_t v = 0; v < vertex_count; ++v) offsets_[v + 1] += offsets_[v];
}

}  // namespace deltamesh
