// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Vertices joined in pairs, pairs in pairs and so on, until one node is left [HAAR-3 .. HAAR-5]: what a
// transform over a mesh runs on. Whole numbers only.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "attributes/haar/levels/places.h"
#include "attributes/surface.h"
#include "base/memory/large_vector.h"
#include "base/simd/four_ints.h"
#include "topology/adjacency.h"

namespace deltamesh {

struct HaarNode {
  HaarPlace place;       ///< mean of its vertices, rounded
  std::uint32_t weight;  ///< how many vertices it has

  FourInts lanes() const noexcept { return std::bit_cast<FourInts>(*this); }
};

/// The nodes of the finer level that a node consists of.
struct HaarChildren {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t first;
  std::uint32_t second;          ///< kNone where there is one alone
  std::uint32_t share_of_first;  ///< of the weight, parts of 2^16; 0 where there is one alone
};

struct HaarLevel {
  LargeVector<HaarNode> nodes;
  Adjacency graph;  ///< rows not sorted, at most kMostHaarNeighbors each, perhaps one-sided
  LargeVector<HaarChildren> children;  ///< of every node, in the level before; empty for the first level
};

/// Longer lists of neighbours are cut, which bounds time and memory whatever the mesh.
inline constexpr std::uint32_t kMostHaarNeighbors = 16;

/// The vertices, each with the copies next to it and its neighbours. O(n).
HaarLevel first_haar_level(const AttributeSurface& surface);

/// `mates`: the node that each node of `fine` is joined with; itself where it stays alone. Nodes come in the
/// order of their first children. O(n).
HaarLevel next_haar_level(const HaarLevel& fine, const LargeVector<std::uint32_t>& mates);

/// From the vertices to a single node; without vertices one level without nodes. Copies of a position are
/// joined first. O(n): every level but the last few has at most 3/4 of the nodes of the one before. Sorts the
/// isolated nodes of a level.
std::vector<HaarLevel> make_haar_levels(const AttributeSurface& surface);

}  // namespace deltamesh
