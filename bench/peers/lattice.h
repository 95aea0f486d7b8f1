// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The cubic lattice over the bounding box that position quantisers of peers use.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "deltamesh/mesh.h"

namespace deltamesh::bench {

struct Lattice {
  std::array<float, 3> origin{};  ///< model units, relative to Mesh::origin
  double cell = 0;                ///< model units

  std::uint16_t symbol(float x, std::size_t axis) const {
    return static_cast<std::uint16_t>(
        std::lround((static_cast<double>(x) - static_cast<double>(origin[axis])) / cell));
  }
  float value(std::uint16_t symbol, std::size_t axis) const {
    return static_cast<float>(static_cast<double>(origin[axis]) + cell * symbol);
  }
};

/// 2^bits points along the longest side; cell 1 for a box without extent. `mesh` has a vertex.
inline Lattice make_lattice(const Mesh& mesh, int bits) {
  std::array<float, 3> low{mesh.positions[0], mesh.positions[1], mesh.positions[2]};
  std::array<float, 3> high = low;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], mesh.positions[i]);
    high[i % 3] = std::max(high[i % 3], mesh.positions[i]);
  }
  double side = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    side = std::max(side, static_cast<double>(high[axis]) - static_cast<double>(low[axis]));
  if (side == 0) return {.origin = low, .cell = 1};
  return {.origin = low, .cell = side / static_cast<double>((1U << bits) - 1)};
}

}  // namespace deltamesh::bench
