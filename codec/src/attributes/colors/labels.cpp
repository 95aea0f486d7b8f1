// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/colors/labels.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace deltamesh {

ColorEdges count_color_edges(std::span<const std::uint8_t> colors, unsigned components,
                             const Adjacency& graph) {
  constexpr int kNearLevels = 8;
  constexpr int kFarLevels = 32;
  ColorEdges edges;
  for (std::uint32_t v = 0; v < graph.vertex_count(); ++v) {
    for (const std::uint32_t u : graph.of(v)) {
      if (u > v) break;
      int difference = 0;
      for (std::size_t c = 0; c < components; ++c)
        difference = std::max(difference, std::abs(colors[std::size_t{components} * v + c] -
                                                   colors[std::size_t{components} * u + c]));
      edges.equal += difference == 0 ? 1 : 0;
      edges.near += difference > 0 && difference <= kNearLevels ? 1 : 0;
      edges.far += difference > kFarLevels ? 1 : 0;
    }
  }
  return edges;
}

bool are_labels(const ColorEdges& edges) noexcept {
  return edges.near == 0 || 4 * edges.near < 2 * edges.equal + 3 * edges.far;
}

}  // namespace deltamesh
