// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "face_neighbors.h"

#include <algorithm>

namespace deltamesh {

std::vector<std::array<std::uint32_t, 3>> earlier_neighbors(std::span<const std::uint32_t> triangles) {
  std::vector<std::array<std::uint32_t, 3>> sides;  // ends of an edge, the lower one first, and its corner
  sides.reserve(triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const std::uint32_t a = triangles[i];
    const std::uint32_t b = triangles[i % 3 == 2 ? i - 2 : i + 1];
    sides.push_back({std::min(a, b), std::max(a, b), i});
  }
  std::ranges::sort(sides);
  std::vector<std::array<std::uint32_t, 3>> neighbors(triangles.size() / 3, {kNoFace, kNoFace, kNoFace});
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const auto& [low, high, corner] = sides[i];
    const auto& [low_before, high_before, corner_before] = sides[i - 1];
    if (low == low_before && high == high_before && corner / 3 != corner_before / 3)
      neighbors[corner / 3][corner % 3] = corner_before / 3;
  }
  return neighbors;
}

}  // namespace deltamesh
