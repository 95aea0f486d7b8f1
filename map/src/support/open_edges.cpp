// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "support/open_edges.h"

#include <array>
#include <cstddef>

#include "support/edge_corners.h"

namespace deltamesh {

OpenEdges::OpenEdges(std::span<const std::uint32_t> triangles, std::size_t vertex_count)
    : offsets_(vertex_count + 1, 0) {
  const EdgeCorners edges(triangles, vertex_count);
  std::vector<std::array<std::uint32_t, 2>> open;
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    const auto own = edges.of(v);
    for (std::size_t i = 0; i < own.size(); ++i) {
      const bool is_alone = (i == 0 || own[i - 1].high != own[i].high) &&
                            (i + 1 == own.size() || own[i + 1].high != own[i].high);
      if (!is_alone || own[i].high == v) continue;
      open.push_back({v, own[i].high});
      ++offsets_[v + 1];
      ++offsets_[own[i].high + 1];
    }
  }
  for (std::size_t v = 0; v < vertex_count; ++v) offsets_[v + 1] += offsets_[v];
  ends_.resize(2 * open.size());
  std::vector<std::uint32_t> next(offsets_.begin(), offsets_.end() - 1);
  for (const auto& [low, high] : open) ends_[next[high]++] = low;  // lower ends first, so that all ascend
  for (const auto& [low, high] : open) ends_[next[low]++] = high;
}

}  // namespace deltamesh
