// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The vertices of a surface by their edges and cubes.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "grid/surface.h"
#include "positions/blend/blend.h"

namespace deltamesh::grid {

/// Where a vertex is.
struct VertexPlace {
  static constexpr unsigned kInCube = 3;  ///< in place of the axis
  static constexpr unsigned kFree = 4;    ///< likewise, of vertices that are not the surface's

  std::array<std::int32_t, 3> node{};  ///< where its edge begins, or the lowest of its cube
  unsigned axis = 0;                   ///< of its edge
};

class VertexFinder {
 public:
  /// `cells`: of the surface's vertices. Both must outlive it.
  VertexFinder(const Surface& surface, std::span<const Cell> cells, std::uint32_t levels);

  /// kNoVertex where there is none. `place.axis`: up to kInCube.
  std::uint32_t find(const VertexPlace& place) const noexcept;
  /// Of a vertex of the surface.
  VertexPlace place_of(std::uint32_t vertex) const noexcept;
  /// The lowest node of the cube that a point is in.
  std::array<std::int32_t, 3> node_of(const Cell& cell) const noexcept;

  std::span<const Cell> cells() const noexcept { return cells_; }

 private:
  const Surface& surface_;
  std::span<const Cell> cells_;
  std::int32_t voxel_;
  std::vector<std::pair<std::array<std::int32_t, 3>, std::uint32_t>> inner_;  ///< by node, ascending
};

}  // namespace deltamesh::grid
