// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A part's border in the order of its stream.
#pragma once

#include <cstdint>
#include <vector>

#include "deltamesh/map/part.h"

namespace deltamesh {

/// The border by the vertices of the decoded stream. `order`: the part's vertex for each of them.
inline std::vector<BorderVertex> border_in_order(const MapPart& part,
                                                 const std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> place(part.mesh.vertex_count(), 0);
  for (std::size_t i = 0; i < part.border.size(); ++i)
    place[part.border[i].vertex] = static_cast<std::uint32_t>(i) + 1;
  std::vector<BorderVertex> border;
  for (std::uint32_t v = 0; v < order.size(); ++v) {
    if (place[order[v]] == 0) continue;
    border.push_back(part.border[place[order[v]] - 1]);
    border.back().vertex = v;
  }
  return border;
}

}  // namespace deltamesh
