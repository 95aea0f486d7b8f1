// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which vertices of a mesh are on edges of a grid, one to an edge, and which cubes their faces lie in.
// Encoder only.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "grid/cube/pattern.h"
#include "positions/blend/blend.h"

namespace deltamesh::grid {

class EdgeVertices {
 public:
  /// A vertex on the edge of `axis` that begins at `node`, or inside the cube there.
  struct Home {
    static constexpr std::uint8_t kCube = 3;
    static constexpr std::uint8_t kNowhere = 4;  ///< another vertex is there

    Node node{};
    std::uint8_t axis = kNowhere;
    bool operator==(const Home&) const = default;
  };

  /// `cells`: not negative, on a lattice of `voxel` steps, an even number, to an edge. Of vertices at home at
  /// the same place the first one is. O(n) expected.
  EdgeVertices(std::span<const Cell> cells, std::int32_t voxel);

  /// Cubes in which a face lies: none, one, or two where it is in the square between them.
  struct Cubes {
    unsigned count = 0;
    std::array<Node, 2> lowest{};
  };
  Cubes cubes_of(const std::array<std::uint32_t, 3>& face) const noexcept;

  /// The edges of the cube at `lowest` at the corners of a face in it.
  Triangle seen_from(const Node& lowest, const std::array<std::uint32_t, 3>& face) const noexcept;

 private:
  std::vector<Home> homes_;
};

}  // namespace deltamesh::grid
