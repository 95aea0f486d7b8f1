// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>

#include "base/broken_rule.h"
#include "base/try.h"
#include "connectivity/faces/faces.h"
#include "format/chunk/tags.h"
#include "grid/rest/rest.h"
#include "positions/positions.h"

namespace deltamesh::grid {

Result<RestMesh> read_rest(std::span<const std::byte> faces, std::span<const std::byte> positions,
                           const RestSize& size, const PositionLattice& lattice) {
  const std::uint32_t largest = std::max({lattice.cells[0], lattice.cells[1], lattice.cells[2]});
  if (largest > kMostRestCells)
    return broken_rule("a lattice too large for faces in no cube", "GRD-11", kTagGrid);
  RestMesh rest;
  DELTAMESH_TRY(auto connectivity, read_connectivity(faces, size.vertices, size.triangles));
  rest.triangles = std::move(connectivity.triangles);
  const PredictiveParameters whole{.kind = PositionKind::kLattice,
                                   .lattice = {.step = {1, 1, 1}, .cells = lattice.cells}};
  DELTAMESH_TRY(const auto rows, read_positions(positions, {rest.triangles, size.vertices}, whole, {}));
  rest.cells.resize(size.vertices);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    // Replacements may be any finite numbers [POSN-11].
    const bool is_on_lattice = rows[i] >= 0 && rows[i] <= static_cast<float>(lattice.cells[i % 3]);
    const std::int32_t at = is_on_lattice ? static_cast<std::int32_t>(rows[i]) : -1;
    if (static_cast<float>(at) != rows[i])
      return broken_rule("a vertex that is not on the lattice", "GRD-11", kTagGrid);
    rest.cells[i / 3][i % 3] = at;
  }
  return rest;
}

VertexFinder::VertexFinder(const Surface& surface, std::span<const Cell> cells, std::uint32_t levels)
    : surface_(surface), cells_(cells), voxel_(2 * static_cast<std::int32_t>(levels)) {
  for (const InnerVertex& inner : surface.inner) inner_.emplace_back(cells[inner.vertex], inner.vertex);
  std::sort(inner_.begin(), inner_.end());
}

std::uint32_t VertexFinder::find(const Cell& cell) const noexcept {
  const auto inner = std::lower_bound(inner_.begin(), inner_.end(), std::pair(cell, 0U));
  if (inner != inner_.end() && inner->first == cell) return inner->second;
  Bricks::Place at{};
  Spot spot{};
  unsigned axis = 3;
  for (unsigned k = 0; k < 3; ++k) {
    const std::int32_t node = cell[k] / voxel_;
    if (cell[k] % voxel_ != 0) axis = k;
    at[k] = node / kSide;
    spot[k] = node % kSide;
  }
  const Brick* const brick = surface_.bricks.find(at);
  if (axis > 2 || brick == nullptr) return kNoVertex;
  const unsigned place = place_of(spot);
  if ((brick->cut[place >> 4] & Brick::cut_bit(place & 15, axis)) == 0) return kNoVertex;
  const unsigned slot = kSlots[0][static_cast<std::size_t>(spot[0])] + row_slot(spot[1], spot[2]);
  const std::uint32_t vertex = surface_.bricks.vertex(*brick, slot, axis);
  return cells_[vertex] == cell ? vertex : kNoVertex;
}

}  // namespace deltamesh::grid
