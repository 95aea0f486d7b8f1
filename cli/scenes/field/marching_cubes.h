// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The zero surface of a field on a voxel lattice, by marching cubes (Lorensen and Cline 1987), layer after
// layer.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "point.h"

namespace deltamesh::scenes {

/// Marks a lattice node that the map has not observed. Cubes with such a corner have no surface.
inline constexpr float kUnobserved = 1e30F;

/// Node (i, j, k) is at base + voxel * (first + (i, j, k)).
struct Lattice {
  std::array<std::uint32_t, 3> nodes{};
  double voxel = 0;
  Point base;
  /// Of a lattice that is a piece of a larger one: its first node. The pieces' points on a node plane that
  /// they share have the same bits.
  Point first{};

  Point at(double i, double j, double k) const noexcept { return base + voxel * (first + Point{i, j, k}); }
  std::size_t layer_size() const noexcept { return std::size_t{nodes[1]} * nodes[2]; }
};

/// Gives the values of the nodes with first index `i`, nodes[1] x nodes[2], the last index fastest; called
/// once for every i, upwards. The span need live only until the next call. Negative is inside.
using LayerSource = std::function<std::span<const float>(std::uint32_t i)>;

struct Surface {
  std::vector<float> positions;          ///< n x 3; each on a lattice edge, two coordinates on the lattice
  std::vector<std::uint32_t> triangles;  ///< m x 3, counter-clockwise seen from outside
};

/// Memory: three layers and the result.
Surface march_cubes(const Lattice& lattice, const LayerSource& layer);

}  // namespace deltamesh::scenes
