// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The edges of a cube: their numbers, what turns make of them, and which have a cube in common [VOX-2]. All
// is told by nodes: an edge by its lower one, a cube by its lowest.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/small_code.h"
#include "predictive/voxel_edges.h"

namespace deltamesh::voxel {

/// x, y, z.
using Nodes = std::array<int, 3>;

inline constexpr unsigned kEdges = 12;  ///< numbered by 4 axis + corner
inline constexpr unsigned kNoEdge = 12;
inline constexpr unsigned kTurns = 24;
inline constexpr std::uint16_t kAllEdges = (1U << kEdges) - 1;

/// From a cube's lowest node to that of every edge.
inline constexpr std::array<Nodes, kEdges> kEdgeNodes = [] {
  std::array<Nodes, kEdges> nodes{};
  for (unsigned i = 0; i < kEdges; ++i) {
    nodes[i][(i / 4 + 1) % 3] = i % 2 != 0 ? 1 : 0;
    nodes[i][(i / 4 + 2) % 3] = i % 4 >= 2 ? 1 : 0;
  }
  return nodes;
}();

/// The same as spots.
inline constexpr std::array<FourShorts, kEdges> kEdgeSpots = [] {
  std::array<FourShorts, kEdges> spots{};
  for (std::size_t i = 0; i < kEdges; ++i) {
    for (std::size_t a = 0; a < 3; ++a)
      spots[i][a] = static_cast<std::int16_t>(kVoxelParts * kEdgeNodes[i][a]);
    spots[i][3] = static_cast<std::int16_t>(kVoxelParts * (i / 4));
  }
  return spots;
}();

/// Edges by axis and node, from -kBelow to kAbove around a cube's lowest node: all that are near an edge of
/// it. What is on no edge is of a fourth axis.
inline constexpr int kBelow = 2;
inline constexpr int kAbove = 3;
inline constexpr EightShorts kNearWeights = {36, 6, 1, 216, 36, 6, 1, 216};
inline constexpr int kNearMiddle = kBelow * (36 + 6 + 1);
inline constexpr std::size_t kNear = 4 * 216;
constexpr std::size_t near_index(std::size_t axis, const Nodes& node) noexcept {
  return 216 * axis + static_cast<std::size_t>(36 * node[0] + 6 * node[1] + node[2] + kNearMiddle);
}

/// By near_index(): the cube's edge there, or kNoEdge.
inline constexpr std::array<std::uint8_t, kNear> kEdgeAt = [] {
  std::array<std::uint8_t, kNear> edges{};
  for (std::uint8_t& edge : edges) edge = kNoEdge;
  for (std::size_t i = 0; i < kEdges; ++i)
    edges[near_index(i / 4, kEdgeNodes[i])] = static_cast<std::uint8_t>(i);
  return edges;
}();

/// Whether one cube has both edges, given by axis and node.
constexpr bool share_cube(std::size_t axis, const Nodes& node, std::size_t axis2,
                          const Nodes& node2) noexcept {
  for (std::size_t a = 0; a < 3; ++a) {
    // Across an edge its cubes reach one node back; the cubes' nodes must overlap.
    const int back = a == axis ? 0 : 1;
    const int back2 = a == axis2 ? 0 : 1;
    if (node[a] < node2[a] - back2 || node2[a] < node[a] - back) return false;
  }
  return true;
}

/// By near_index(): the cube's edges that have a cube in common with the one there, but for itself.
inline constexpr std::array<std::uint16_t, kNear> kEdgesNear = [] {
  std::array<std::uint16_t, kNear> sets{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (int x = -kBelow; x <= kAbove; ++x) {
      for (int y = -kBelow; y <= kAbove; ++y) {
        for (int z = -kBelow; z <= kAbove; ++z) {
          const Nodes node = {x, y, z};
          std::uint16_t set = 0;
          for (std::size_t i = 0; i < kEdges; ++i) {
            const bool same = i / 4 == axis && kEdgeNodes[i] == node;
            if (!same && share_cube(axis, node, i / 4, kEdgeNodes[i]))
              set |= static_cast<std::uint16_t>(1U << i);
          }
          sets[near_index(axis, node)] = set;
        }
      }
    }
  }
  return sets;
}();

/// Turn by turn the number that every edge gets; kNoEdge for itself and beyond.
inline constexpr std::array<std::array<std::uint8_t, 16>, kTurns> kTurned = [] {
  constexpr std::array<Nodes, 6> kAxes = {{{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  std::array<std::array<std::uint8_t, 16>, kTurns> turned{};
  std::size_t turn = 0;
  for (std::size_t axes = 0; axes < kAxes.size(); ++axes) {
    for (unsigned signs = 0; signs < 8; ++signs) {
      // Not the mirrorings: an odd number of signs goes with a swap of two axes.
      const unsigned odd = (signs ^ signs >> 1 ^ signs >> 2) & 1;
      if (odd != (axes >= 3 ? 1U : 0U)) continue;
      turned[turn].fill(kNoEdge);
      for (std::size_t i = 0; i < kEdges; ++i) {
        Nodes to{};
        std::size_t axis = 0;
        for (std::size_t a = 0; a < 3; ++a) {
          const auto from = static_cast<std::size_t>(kAxes[axes][a]);
          if (from == i / 4) axis = a;
          const bool swaps = (signs >> a & 1) != 0 && from != i / 4;
          to[a] = swaps ? 1 - kEdgeNodes[i][from] : kEdgeNodes[i][from];
        }
        turned[turn][i] = kEdgeAt[near_index(axis, to)];
      }
      ++turn;
    }
  }
  return turned;
}();

/// Turn by turn what a set of the edges of one axis becomes, axis by axis.
inline constexpr std::array<std::array<std::array<std::uint16_t, 16>, 3>, kTurns> kTurnedSets = [] {
  std::array<std::array<std::array<std::uint16_t, 16>, 3>, kTurns> turned{};
  for (std::size_t turn = 0; turn < kTurns; ++turn)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t set = 0; set < 16; ++set)
        for (std::size_t i = 0; i < 4; ++i)
          if ((set >> i & 1) != 0)
            turned[turn][axis][set] |= static_cast<std::uint16_t>(1U << kTurned[turn][4 * axis + i]);
  return turned;
}();

/// What a set of edges becomes.
constexpr unsigned turned_set(std::size_t turn, unsigned set) noexcept {
  const auto& turned = kTurnedSets[turn];
  return turned[0][set & 15] | turned[1][set >> 4 & 15] | turned[2][set >> 8];
}

/// Turn by turn the edge that gets a number.
inline constexpr std::array<std::array<std::uint8_t, kEdges>, kTurns> kBeforeTurn = [] {
  std::array<std::array<std::uint8_t, kEdges>, kTurns> before{};
  for (std::size_t turn = 0; turn < kTurns; ++turn)
    for (std::size_t i = 0; i < kEdges; ++i) before[turn][kTurned[turn][i]] = static_cast<std::uint8_t>(i);
  return before;
}();

/// One of the cubes that two edges have in common, turned so that the first edge gets number 0 and the second
/// the least number that it can have.
struct alignas(16) PairCube {
  FourShorts lowest{};     ///< as a spot, from the first edge's node
  std::uint16_t others{};  ///< the cube's edges but for the two, before the turn
  std::uint8_t turn = 0;
  std::uint8_t kind = 0;  ///< which of the numbers that second edges have, ascending
};
inline constexpr unsigned kPairKinds = 6;

/// The cubes of two edges, the lower one first; where there is one only it is there twice.
struct CubePair {
  std::array<PairCube, 2> cubes{};
  std::uint8_t count = 0;    ///< 0: there is none
  std::uint8_t axis = 0;     ///< of two cubes: where they lie apart
  std::int16_t between = 0;  ///< the spot between them there, from the first edge's node
};

/// The turn that gives `first` the number 0 and `second` the least.
constexpr unsigned turn_of_pair(unsigned first, unsigned second) noexcept {
  unsigned best = 0;
  unsigned least = kEdges;
  for (unsigned turn = 0; turn < kTurns; ++turn) {
    if (kTurned[turn][first] != 0 || kTurned[turn][second] >= least) continue;
    best = turn;
    least = kTurned[turn][second];
  }
  return best;
}

/// Of a second edge's number, which is 1, 3, 4, 5, 6 or 7.
constexpr std::uint8_t kind_of(unsigned number) noexcept {
  return static_cast<std::uint8_t>(number == 1 ? 0 : number - 2);
}

/// `node`: the second edge's, from the first one's.
constexpr CubePair make_pair(std::size_t axis, std::size_t axis2, const Nodes& node) noexcept {
  CubePair pair;
  if (axis == axis2 && node == Nodes{}) return pair;
  // The cubes of the first edge, x slowest.
  for (int i = 0; i < 8; ++i) {
    const Nodes lowest = {(i >> 2) - 1, (i >> 1 & 1) - 1, (i & 1) - 1};
    if (lowest[axis] != 0) continue;
    const Nodes to = {node[0] - lowest[0], node[1] - lowest[1], node[2] - lowest[2]};
    const unsigned first = kEdgeAt[near_index(axis, {-lowest[0], -lowest[1], -lowest[2]})];
    const unsigned second = kEdgeAt[near_index(axis2, to)];
    if (second == kNoEdge) continue;
    PairCube& cube = pair.cubes[pair.count++];
    for (std::size_t a = 0; a < 3; ++a) cube.lowest[a] = static_cast<std::int16_t>(kVoxelParts * lowest[a]);
    cube.others = static_cast<std::uint16_t>(kAllEdges & ~(1U << first | 1U << second));
    cube.turn = static_cast<std::uint8_t>(turn_of_pair(first, second));
    cube.kind = kind_of(kTurned[cube.turn][second]);
  }
  if (pair.count == 1) pair.cubes[1] = pair.cubes[0];
  for (std::uint8_t a = 0; a < 3; ++a)
    if (pair.cubes[0].lowest[a] != pair.cubes[1].lowest[a]) pair.axis = a;
  pair.between = pair.cubes[1].lowest[pair.axis];
  return pair;
}

/// By axes and steps between nodes that are near each other.
inline constexpr EightShorts kPairWeights = {25, 5, 1, 125, 25, 5, 1, 125};  ///< 3 a + b of the axes a and b
inline constexpr int kPairMiddle = kMostApart * (25 + 5 + 1);
inline constexpr std::size_t kPairs = 1 + 3 * 32;  ///< none, and what every edge shares cubes with

struct PairTable {
  std::array<std::uint8_t, 9 * 125> places{};
  std::array<CubePair, kPairs> pairs{};
};
DELTAMESH_TABULATE PairTable make_pair_table() noexcept {
  PairTable table;
  std::size_t count = 1;
  for (std::size_t axes = 0; axes < 9; ++axes) {
    for (int i = 0; i < 27; ++i) {
      const Nodes node = {i / 9 - 1, i / 3 % 3 - 1, i % 3 - 1};
      const CubePair pair = make_pair(axes / 3, axes % 3, node);
      if (pair.count == 0) continue;
      const int place = 25 * node[0] + 5 * node[1] + node[2] + kPairMiddle;
      table.places[125 * axes + static_cast<std::size_t>(place)] = static_cast<std::uint8_t>(count);
      table.pairs[count++] = pair;
    }
  }
  return table;
}
inline const PairTable kPairTable = make_pair_table();

/// From the middle of a cube to that of an edge, but for its own axis.
inline constexpr std::array<Nodes, kEdges> kEdgeMiddles = [] {
  std::array<Nodes, kEdges> middles{};
  for (std::size_t i = 0; i < kEdges; ++i)
    for (std::size_t a = 0; a < 3; ++a)
      middles[i][a] = a == i / 4 ? 0 : kVoxelParts * kEdgeNodes[i][a] - kVoxelMiddle;
  return middles;
}();

}  // namespace deltamesh::voxel
