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
/// Nodes of other bricks that it knows, too, on each side: two, and one more that may be wrong.
inline constexpr int kMargin = 3;
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

/// What is beyond the brick of a cube: a bit for every axis on which it has corners in the next brick.
constexpr unsigned beyond(unsigned place) noexcept {
  // A digit of 15 carries into the bit above it.
  const unsigned carries =
      ((place & 0xf) + 1) | ((place & 0xf0) + 0x10) << 1 | ((place & 0xf00) + 0x100) << 2;
  return (carries >> 4 & 1) | (carries >> 8 & 2) | (carries >> 12 & 4);
}

/// Vertices on edges that begin at 4 x 2 x 2 nodes of a brick stand side by side, in a block.
inline constexpr unsigned kBlockNodes = 16;
inline constexpr std::size_t kBlocks = kPlaces / kBlockNodes;
/// Nodes in the order of their blocks: the sum of these of x, y and z; 16 is 0, of the brick beyond.
inline constexpr std::array<std::array<std::uint16_t, kSide + 1>, 3> kSlots = [] {
  std::array<std::array<std::uint16_t, kSide + 1>, 3> slots{};
  for (unsigned i = 0; i < kSide; ++i) {
    slots[0][i] = static_cast<std::uint16_t>(i % 4 + i / 4 * kBlockNodes);
    slots[1][i] = static_cast<std::uint16_t>(i % 2 * 4 + i / 2 * 4 * kBlockNodes);
    slots[2][i] = static_cast<std::uint16_t>(i % 2 * 8 + i / 2 * 32 * kBlockNodes);
  }
  return slots;
}();
constexpr unsigned row_slot(int y, int z) noexcept {
  return kSlots[1][static_cast<std::size_t>(y)] + kSlots[2][static_cast<std::size_t>(z)];
}

struct Brick {
  /// Place in `rows` of the nodes with these y and z, -3 to 18.
  static constexpr std::size_t row_at(int y, int z) noexcept {
    return static_cast<std::size_t>((z + kMargin) * kReach + y + kMargin);
  }
  static constexpr std::size_t row_at(unsigned place) noexcept {
    return (place >> 8) * kReach + (place >> 4 & 15) + kMargin * (kReach + 1);
  }
  static constexpr unsigned kInsideShift = 32;

  static constexpr std::uint8_t kSeen = 0x80;  ///< of a cube that is coded or waits for it
  static constexpr std::uint8_t kFaceless = 0x3f;

  static constexpr std::uint64_t cut_bit(unsigned x, unsigned axis) noexcept {
    return std::uint64_t{1} << (kSide * axis + x);
  }

  std::array<std::int32_t, 3> at;  ///< in bricks
  std::uint32_t number;            ///< of all bricks
  std::array<Brick*, 27> near;     ///< null, or that at d - 1 from here, for d[0] + 3 d[1] + 9 d[2]

  /// Known nodes: bit x + 3 is set if one is outside, bit x + 35 if it is inside.
  std::array<std::uint64_t, kReach * kReach> rows;
  /// kSeen, and how many cubes without faces share with it a face (times 8) or an edge (7 at most).
  std::uint8_t* cubes;  ///< by place; see Bricks::free_cubes()
  /// Edges with vertices: bit x + 16 axis, by y + 16 z.
  std::array<std::uint64_t, kSide * kSide> cut;
  std::array<std::uint32_t, kBlocks> blocks;  ///< numbers of those that have vertices, others 0
};

}  // namespace deltamesh::grid
