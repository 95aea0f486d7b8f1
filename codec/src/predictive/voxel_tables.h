// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The edges of a cube: their numbers, what turns make of them, and which have a cube in common [VOX-2].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "predictive/voxel_lanes.h"

namespace deltamesh::voxel {

/// In half voxels, the last lane 0.
using Steps = std::array<std::int32_t, 4>;

inline constexpr unsigned kEdges = 12;
inline constexpr unsigned kNoEdge = 12;
inline constexpr unsigned kTurns = 24;
inline constexpr std::uint16_t kAllEdges = (1U << kEdges) - 1;

/// From the centre to every edge, numbered by 4 axis + corner.
inline constexpr std::array<Steps, kEdges> kEdgeSteps = [] {
  std::array<Steps, kEdges> edges{};
  for (unsigned i = 0; i < kEdges; ++i) {
    const unsigned axis = i / 4;
    edges[i][(axis + 1) % 3] = i % 2 != 0 ? 1 : -1;
    edges[i][(axis + 2) % 3] = i % 4 >= 2 ? 1 : -1;
  }
  return edges;
}();

constexpr int size_of(int step) noexcept { return step < 0 ? -step : step; }

constexpr std::size_t step_index_of(const Steps& steps) noexcept {
  return step_index(steps[0], steps[1], steps[2]);
}

/// By step_index(): the edge at these steps from a cube's centre, or kNoEdge.
inline constexpr std::array<std::uint8_t, kStepIndices> kEdgeAt = [] {
  std::array<std::uint8_t, kStepIndices> edges{};
  for (std::uint8_t& edge : edges) edge = kNoEdge;
  for (unsigned i = 0; i < kEdges; ++i) edges[step_index_of(kEdgeSteps[i])] = static_cast<std::uint8_t>(i);
  return edges;
}();

/// Turn by turn the number that every edge gets; kNoEdge for itself and beyond.
inline constexpr std::array<std::array<std::uint8_t, 16>, kTurns> kTurned = [] {
  constexpr std::array<std::array<std::size_t, 3>, 6> kAxes = {
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  std::array<std::array<std::uint8_t, 16>, kTurns> turned{};
  std::size_t turn = 0;
  for (std::size_t axes = 0; axes < kAxes.size(); ++axes) {
    for (unsigned signs = 0; signs < 8; ++signs) {
      // Not the mirrorings: an odd number of signs goes with a swap of two axes.
      const unsigned odd = (signs ^ signs >> 1 ^ signs >> 2) & 1;
      if (odd != (axes >= 3 ? 1U : 0U)) continue;
      turned[turn].fill(kNoEdge);
      for (std::size_t i = 0; i < kEdges; ++i) {
        Steps to{};
        for (std::size_t a = 0; a < 3; ++a)
          to[a] = kEdgeSteps[i][kAxes[axes][a]] * ((signs >> a & 1) != 0 ? -1 : 1);
        turned[turn][i] = kEdgeAt[step_index_of(to)];
      }
      ++turn;
    }
  }
  return turned;
}();

/// Turn by turn the edge that gets a number.
inline constexpr std::array<std::array<std::uint8_t, kEdges>, kTurns> kBeforeTurn = [] {
  std::array<std::array<std::uint8_t, kEdges>, kTurns> before{};
  for (std::size_t turn = 0; turn < kTurns; ++turn)
    for (std::size_t i = 0; i < kEdges; ++i) before[turn][kTurned[turn][i]] = static_cast<std::uint8_t>(i);
  return before;
}();

/// Whether two places of edges have a cube in common, `to` being given from the other, whose axis is `axis`.
constexpr bool share_cube(std::size_t axis, const Steps& to) noexcept {
  for (std::size_t a = 0; a < 3; ++a) {
    // An even step leaves both edges along the axis, or both across it.
    const bool both_along = a == axis && to[a] % 2 == 0;
    if (size_of(to[a]) > (both_along ? 0 : to[a] % 2 == 0 ? 2 : 1)) return false;
  }
  return true;
}

/// By step_index(), from a cube's centre to an edge: the cube's edges that have a cube in common with it and
/// are not it; all where that is too far off for any.
inline constexpr std::array<std::uint16_t, kStepIndices> kEdgesNear = [] {
  std::array<std::uint16_t, kStepIndices> sets{};
  for (int x = -kMostSteps; x <= kMostSteps; ++x) {
    for (int y = -kMostSteps; y <= kMostSteps; ++y) {
      for (int z = -kMostSteps; z <= kMostSteps; ++z) {
        std::uint16_t set = 0;
        const bool is_far = size_of(x) == kMostSteps || size_of(y) == kMostSteps || size_of(z) == kMostSteps;
        for (unsigned i = 0; i < kEdges && !is_far; ++i) {
          const Steps& own = kEdgeSteps[i];
          const Steps to{x - own[0], y - own[1], z - own[2], 0};
          const bool same = to[0] == 0 && to[1] == 0 && to[2] == 0;
          if (!same && share_cube(i / 4, to)) set |= static_cast<std::uint16_t>(1U << i);
        }
        sets[step_index(x, y, z)] = set != 0 ? set : kAllEdges;
      }
    }
  }
  return sets;
}();

/// The cubes that two edges have in common, and how each is turned so that the first edge gets number 0 and
/// the second the least number that it can have.
struct CubePair {
  std::array<Steps, 2> centers{};  ///< from the first edge, the lower one first
  std::array<std::uint8_t, 2> turns{};
  std::array<std::uint8_t, 2> kinds{};  ///< which of the numbers that second edges have, ascending
  std::uint8_t cubes = 0;               ///< 0: there is none, or more than two
  std::uint8_t axis = 0;                ///< of two cubes: where they lie apart
};
inline constexpr unsigned kPairKinds = 6;

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

/// By a second edge's number: its kind.
inline constexpr std::array<std::uint8_t, kEdges> kKindOf = [] {
  std::array<std::uint8_t, kEdges> kinds{};
  std::array<bool, kEdges> used{};
  for (unsigned second = 1; second < kEdges; ++second) used[kTurned[turn_of_pair(0, second)][second]] = true;
  std::uint8_t kind = 0;
  for (std::size_t i = 0; i < kEdges; ++i)
    if (used[i]) kinds[i] = kind++;
  return kinds;
}();

constexpr CubePair make_pair(std::size_t axis, const Steps& to) noexcept {
  CubePair pair;
  if (to[0] == 0 && to[1] == 0 && to[2] == 0) return pair;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        const unsigned first = kEdgeAt[step_index(-x, -y, -z)];
        const Steps second_steps{to[0] - x, to[1] - y, to[2] - z, 0};
        bool is_near = first != kNoEdge && first / 4 == axis;
        for (const std::int32_t step : second_steps) is_near = is_near && size_of(step) <= 1;
        const unsigned second = is_near ? kEdgeAt[step_index_of(second_steps)] : kNoEdge;
        if (second == kNoEdge) continue;
        const std::size_t i = pair.cubes++;
        pair.centers[i] = {x, y, z, 0};
        pair.turns[i] = static_cast<std::uint8_t>(turn_of_pair(first, second));
        pair.kinds[i] = kKindOf[kTurned[pair.turns[i]][second]];
      }
    }
  }
  for (std::uint8_t a = 0; a < 3 && pair.cubes == 2; ++a)
    if (pair.centers[0][a] != pair.centers[1][a]) pair.axis = a;
  return pair;
}

inline constexpr std::size_t kPairs = 1 + 3 * 32;  ///< and none; every edge shares cubes with 32 others

struct PairTable {
  /// By the first edge's axis and the steps to the second.
  std::array<std::array<std::uint8_t, kStepIndices>, 3> places{};
  std::array<CubePair, kPairs> pairs{};
};
inline constexpr PairTable kPairTable = [] {
  PairTable table;
  std::size_t count = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (int x = -2; x <= 2; ++x) {
      for (int y = -2; y <= 2; ++y) {
        for (int z = -2; z <= 2; ++z) {
          const CubePair pair = make_pair(axis, {x, y, z, 0});
          if (pair.cubes == 0) continue;
          table.places[axis][step_index(x, y, z)] = static_cast<std::uint8_t>(count);
          table.pairs[count++] = pair;
        }
      }
    }
  }
  return table;
}();

}  // namespace deltamesh::voxel
