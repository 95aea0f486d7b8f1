// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "support/face_neighbors.h"

#include "support/edge_corners.h"

namespace deltamesh {

std::vector<std::array<std::uint32_t, 3>> earlier_neighbors(std::span<const std::uint32_t> triangles,
                                                            std::size_t vertex_count) {
  std::vector<std::array<std::uint32_t, 3>> neighbors(triangles.size() / 3, {kNoFace, kNoFace, kNoFace});
  const EdgeCorners edges(triangles, vertex_count);
  for (std::size_t v = 0; v < vertex_count; ++v) {
    const auto own = edges.of(v);
    for (std::size_t i = 1; i < own.size(); ++i) {
      const std::uint32_t corner = own[i].corner;
      const std::uint32_t before = own[i - 1].corner;
      if (own[i].high == own[i - 1].high && corner / 3 != before / 3)
        neighbors[corner / 3][corner % 3] = before / 3;
    }
  }
  return neighbors;
}

}  // namespace deltamesh
