// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Tables of a cube's edges: their numbers, the cube's rotations, and which edges share a cube [VOX-2]. An
// edge is given by its lower node, a cube by its lowest node.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/small_code.h"
#include "positions/grid/edges.h"

namespace deltamesh::voxel {

/// x, y, z.
using Nodes = std::array<int, 3>;

inline constexpr unsigned kEdges = 12;  ///< numbered by 4 axis + corner
inline constexpr unsigned kNoEdge = 12;
inline constexpr unsigned kRotations = 24;
inline constexpr std::uint16_t kAllEdges = (1U << kEdges) - 1;

/// The node of every edge, relative to the cube's lowest node.
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

/// Index of an edge by axis (3: on no edge) and node, -kBelow to kAbove from a cube's lowest node.
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

/// By near_index(): the set of the cube's edges that share a cube with that edge, without that edge itself.
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

/// By rotation and edge: the edge's number after the rotation; kNoEdge for kNoEdge and above.
inline constexpr std::array<std::array<std::uint8_t, 16>, kRotations> kRotated = [] {
  constexpr std::array<Nodes, 6> kAxes = {{{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  std::array<std::array<std::uint8_t, 16>, kRotations> rotated{};
  std::size_t rotation = 0;
  for (std::size_t axes = 0; axes < kAxes.size(); ++axes) {
    for (unsigned signs = 0; signs < 8; ++signs) {
      // Not the mirrorings: an odd number of signs goes with a swap of two axes.
      const unsigned odd = (signs ^ signs >> 1 ^ signs >> 2) & 1;
      if (odd != (axes >= 3 ? 1U : 0U)) continue;
      rotated[rotation].fill(kNoEdge);
      for (std::size_t i = 0; i < kEdges; ++i) {
        Nodes to{};
        std::size_t axis = 0;
        for (std::size_t a = 0; a < 3; ++a) {
          const auto from = static_cast<std::size_t>(kAxes[axes][a]);
          if (from == i / 4) axis = a;
          const bool swaps = (signs >> a & 1) != 0 && from != i / 4;
          to[a] = swaps ? 1 - kEdgeNodes[i][from] : kEdgeNodes[i][from];
        }
        rotated[rotation][i] = kEdgeAt[near_index(axis, to)];
      }
      ++rotation;
    }
  }
  return rotated;
}();

/// By rotation, axis and set of that axis' four edges: the set after the rotation.
inline constexpr std::array<std::array<std::array<std::uint16_t, 16>, 3>, kRotations> kRotatedSets = [] {
  std::array<std::array<std::array<std::uint16_t, 16>, 3>, kRotations> sets{};
  for (std::size_t rotation = 0; rotation < kRotations; ++rotation)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t set = 0; set < 16; ++set)
        for (std::size_t i = 0; i < 4; ++i)
          if ((set >> i & 1) != 0)
            sets[rotation][axis][set] |= static_cast<std::uint16_t>(1U << kRotated[rotation][4 * axis + i]);
  return sets;
}();

/// The set of edges `set` after the rotation; bit e stands for edge e.
constexpr unsigned rotated_set(std::size_t rotation, unsigned set) noexcept {
  const auto& rotated = kRotatedSets[rotation];
  return rotated[0][set & 15] | rotated[1][set >> 4 & 15] | rotated[2][set >> 8];
}

/// By rotation and number after it: the edge. The inverse of kRotated.
inline constexpr std::array<std::array<std::uint8_t, kEdges>, kRotations> kBeforeRotation = [] {
  std::array<std::array<std::uint8_t, kEdges>, kRotations> before{};
  for (std::size_t rotation = 0; rotation < kRotations; ++rotation)
    for (std::size_t i = 0; i < kEdges; ++i)
      before[rotation][kRotated[rotation][i]] = static_cast<std::uint8_t>(i);
  return before;
}();

/// One of the cubes that two edges share. Its rotation gives the first edge the number 0 and the second edge
/// the least number possible.
struct alignas(16) PairCube {
  FourShorts lowest{};     ///< lowest node as a spot, relative to the first edge's node
  std::uint16_t others{};  ///< the cube's edges except these two, before the rotation
  std::uint8_t rotation = 0;
  std::uint8_t kind = 0;  ///< index of the second edge's number among 1, 3, 4, 5, 6, 7
};
inline constexpr unsigned kPairKinds = 6;

/// The cubes that two edges share, the lower one first; a single cube is stored twice.
struct CubePair {
  std::array<PairCube, 2> cubes{};
  std::uint8_t count = 0;    ///< 0 to 2
  std::uint8_t axis = 0;     ///< if count is 2: the axis along which the cubes differ
  std::int16_t between = 0;  ///< spot of the face between them on that axis, from the first edge's node
};

/// The first rotation that gives `first` the number 0 and `second` the least number possible.
constexpr unsigned rotation_of_pair(unsigned first, unsigned second) noexcept {
  unsigned best = 0;
  unsigned least = kEdges;
  for (unsigned rotation = 0; rotation < kRotations; ++rotation) {
    if (kRotated[rotation][first] != 0 || kRotated[rotation][second] >= least) continue;
    best = rotation;
    least = kRotated[rotation][second];
  }
  return best;
}

/// Index of `number`, which is 1, 3, 4, 5, 6 or 7, among these.
constexpr std::uint8_t kind_of(unsigned number) noexcept {
  return static_cast<std::uint8_t>(number == 1 ? 0 : number - 2);
}

/// `node`: the second edge's node relative to the first one's.
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
    cube.rotation = static_cast<std::uint8_t>(rotation_of_pair(first, second));
    cube.kind = kind_of(kRotated[cube.rotation][second]);
  }
  if (pair.count == 1) pair.cubes[1] = pair.cubes[0];
  for (std::uint8_t a = 0; a < 3; ++a)
    if (pair.cubes[0].lowest[a] != pair.cubes[1].lowest[a]) pair.axis = a;
  pair.between = pair.cubes[1].lowest[pair.axis];
  return pair;
}

/// Index of a pair of edges by their axes and the step between their nodes.
inline constexpr EightShorts kPairWeights = {25, 5, 1, 125, 25, 5, 1, 125};  ///< 3 a + b of the axes a and b
inline constexpr int kPairMiddle = kMostApart * (25 + 5 + 1);
inline constexpr std::size_t kPairs =
    1 + 3 * 32;  ///< "no cube", and the 32 edges that share a cube with an edge of each axis

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

/// The middle of every edge relative to the cube's centre, in parts of a voxel; 0 on the edge's own axis.
inline constexpr std::array<Nodes, kEdges> kEdgeMiddles = [] {
  std::array<Nodes, kEdges> middles{};
  for (std::size_t i = 0; i < kEdges; ++i)
    for (std::size_t a = 0; a < 3; ++a)
      middles[i][a] = a == i / 4 ? 0 : kVoxelParts * kEdgeNodes[i][a] - kVoxelMiddle;
  return middles;
}();

}  // namespace deltamesh::voxel
