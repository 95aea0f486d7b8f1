// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Vertices whose positions a highpass stream tells.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "topology/adjacency.h"

namespace deltamesh {

/// Components with fewer vertices are not solved: every vertex of them is an anchor [ANCH-2].
inline constexpr std::uint32_t kSmallestSolvedComponent = 8;

struct Anchors {
  std::vector<std::uint32_t> vertices;  ///< ascending
  std::uint32_t density = 0;            ///< largest hop distance of a vertex to its nearest anchor
};

/// Per anchor 1 if its component has another one, else 0. O(components + anchors).
inline std::vector<std::uint8_t> shared_anchors(const Components& components,
                                                std::span<const std::uint32_t> anchors) {
  std::vector<std::uint32_t> count(components.count, 0);
  for (const std::uint32_t anchor : anchors) ++count[components.label[anchor]];
  std::vector<std::uint8_t> shared;
  for (const std::uint32_t anchor : anchors) shared.push_back(count[components.label[anchor]] > 1 ? 1 : 0);
  return shared;
}

}  // namespace deltamesh
