// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/cell_quality.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/memory/large_vector.h"
#include "measure/measure.h"

namespace deltamesh {
namespace {

/// A decoder's position.
Vec3 decoded_position(const PositionLattice& lattice, const Cell& cell) noexcept {
  Vec3 position;
  for (std::size_t axis = 0; axis < 3; ++axis)
    position[axis] = static_cast<float>(lattice.at(axis, cell[axis]));
  return position;
}

}  // namespace

Quality positional_quality(std::span<const Vec3> positions, std::span<const Cell> cells,
                           const PositionLattice& lattice, const MeshEdges& edges) noexcept {
  double squares = 0;
  double largest = 0;
  const auto& lone = edges.lone_vertices;
  std::size_t next_lone = 0;
  for (std::size_t v = 0; v < cells.size(); ++v) {
    const Vec3 error = positions[v] - decoded_position(lattice, cells[v]);
    const double square = dot(error, error);
    largest = std::max(largest, square);
    if (next_lone < lone.size() && lone[next_lone] == v) {
      ++next_lone;
    } else {
      squares += square;
    }
  }
  const auto count = static_cast<double>(std::max<std::size_t>(cells.size() - lone.size(), 1));
  return {.lfe_rms = std::sqrt(squares / count), .max_error = std::sqrt(largest)};
}

double visual_error(const MeshEdges& edges, std::span<const Vec3> positions, std::span<const Cell> cells,
                    const PositionLattice& lattice) {
  std::vector<Vec3> decoded;
  reserve_large(decoded, cells.size());
  for (const Cell& cell : cells) decoded.push_back(decoded_position(lattice, cell));
  return measure_vde(edges, positions, decoded);
}

}  // namespace deltamesh
