// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "grid/rest/vertex_finder.h"

#include <algorithm>

namespace deltamesh::grid {

VertexFinder::VertexFinder(const Surface& surface, std::span<const Cell> cells, std::uint32_t levels)
    : surface_(surface), cells_(cells), voxel_(2 * static_cast<std::int32_t>(levels)) {
  for (const InnerVertex& inner : surface.inner)
    inner_.emplace_back(node_of(cells[inner.vertex]), inner.vertex);
  std::sort(inner_.begin(), inner_.end());
}

std::array<std::int32_t, 3> VertexFinder::node_of(const Cell& cell) const noexcept {
  return {cell[0] / voxel_, cell[1] / voxel_, cell[2] / voxel_};
}

std::uint32_t VertexFinder::find(const VertexPlace& place) const noexcept {
  if (place.axis == VertexPlace::kInCube) {
    const auto inner = std::lower_bound(inner_.begin(), inner_.end(), std::pair(place.node, 0U));
    return inner != inner_.end() && inner->first == place.node ? inner->second : kNoVertex;
  }
  Bricks::Place at{};
  Spot spot{};
  for (unsigned k = 0; k < 3; ++k) {
    at[k] = place.node[k] / kSide;
    spot[k] = place.node[k] % kSide;
  }
  const Brick* const brick = surface_.bricks.find(at);
  if (brick == nullptr) return kNoVertex;
  const unsigned node = grid::place_of(spot);
  if ((brick->cut[node >> 4] & Brick::cut_bit(node & 15, place.axis)) == 0) return kNoVertex;
  const unsigned slot = kSlots[0][static_cast<std::size_t>(spot[0])] + row_slot(spot[1], spot[2]);
  return surface_.bricks.vertex(*brick, slot, place.axis);
}

VertexPlace VertexFinder::place_of(std::uint32_t vertex) const noexcept {
  const Cell& cell = cells_[vertex];
  VertexPlace place{node_of(cell), VertexPlace::kInCube};
  if (find(place) == vertex) return place;
  for (unsigned k = 0; k < 3; ++k)
    if (cell[k] % voxel_ != 0) place.axis = k;
  return place;
}

}  // namespace deltamesh::grid
