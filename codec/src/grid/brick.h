// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What is known of 16 x 16 x 16 nodes of a grid, and of the cubes whose lowest corners they are.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace deltamesh::grid {

inline constexpr int kSide = 16;              ///< of a brick, nodes
inline constexpr std::size_t kPlaces = 4096;  ///< nodes of a brick; the one at (x, y, z) is x + 16 y + 256 z
inline constexpr int kMargin = 2;             ///< nodes of other bricks that it knows, too, on each side
inline constexpr int kReach = kSide + 2 * kMargin;

inline constexpr std::uint32_t kNoVertex = 0xffffffff;

/// Of a node of a brick: x, y, z.
using Spot = std::array<int, 3>;
constexpr Spot spot_of(unsigned place) noexcept {
  return {static_cast<int>(place & 15), static_cast<int>(place >> 4 & 15), static_cast<int>(place >> 8)};
}
constexpr unsigned place_of(const Spot& spot) noexcept {
  return static_cast<unsigned>(spot[0] + kSide * spot[1] + kSide * kSide * spot[2]);
}

/// From a cube's lowest node to its corners, in the same brick.
inline constexpr std::array<std::uint16_t, 8> kCornerSteps = {0, 1, 16, 17, 256, 257, 272, 273};

/// Nodes of one brick that are known, in groups whose vertices stand side by side.
inline constexpr unsigned kGroup = 64;

struct Brick {
  /// Place in `rows` of the nodes with these y and z, -2 to 17.
  static constexpr std::size_t row_at(int y, int z) noexcept {
    return static_cast<std::size_t>((z + kMargin) * kReach + y + kMargin);
  }
  static constexpr std::size_t row_at(unsigned place) noexcept {
    return (place >> 8) * kReach + (place >> 4 & 15) + kMargin * (kReach + 1);
  }
  static constexpr unsigned kInsideShift = 32;

  static constexpr std::uint8_t kSeen = 0x80;  ///< of a cube that is coded or waits for it
  static constexpr std::uint8_t kFaceless = 0x3f;

  std::array<std::int32_t, 3> at;  ///< in bricks
  std::uint32_t number;            ///< of all bricks
  std::array<Brick*, 27> near;     ///< null, or that at d - 1 from here, for d[0] + 3 d[1] + 9 d[2]

  /// Known nodes: bit x + 2 is set if one is outside, bit x + 34 if it is inside.
  std::array<std::uint64_t, kReach * kReach> rows;
  /// kSeen, and how many cubes without faces share with it a face (times 8) or an edge (7 at most).
  std::array<std::uint8_t, kPlaces> cubes;
  /// Edges with vertices, by axis, y + 16 z and bit x.
  std::array<std::array<std::uint16_t, kSide * kSide>, 3> cut;
  std::uint32_t known_nodes;
  std::array<std::uint32_t, kPlaces / kGroup> groups;  ///< places of the vertices of a group
  std::array<std::uint16_t, kPlaces> ranks;            ///< of known nodes: how many were known before
};

}  // namespace deltamesh::grid
