// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Edges of a voxel grid, on which marching cubes puts vertices, and levels on them [VOX-1, VOX-3, VOX-6].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "positions/blend/blend.h"
#include "positions/grid/lanes.h"

namespace deltamesh {

inline constexpr int kVoxelBits = 7;
inline constexpr std::int16_t kVoxelParts = 1 << kVoxelBits;  ///< of a voxel's side, for spots
inline constexpr std::int16_t kVoxelMiddle = kVoxelParts / 2;

/// Position of a vertex in parts of a voxel, modulo 2^16, so that differences between near vertices are
/// exact; then kVoxelParts times the axis of its edge, or kNoAxis if it is on no edge. Small, as each one is
/// read many times.
struct alignas(8) VoxelSpot {
  static constexpr std::int16_t kNoAxis = 4 * kVoxelParts;  ///< a bit that no axis has

  FourShorts at;

  bool on_edge() const noexcept { return at[3] != kNoAxis; }
};
inline constexpr VoxelSpot kOffEdges{{0, 0, 0, VoxelSpot::kNoAxis}};

/// Lower node of an edge; the last lane is 0. A vertex on no edge has kNowhere, which is near no node.
inline constexpr FourInts kNowhere = {-(1 << 30), -(1 << 30), -(1 << 30), 0};
inline constexpr std::int32_t kMostApart = 2;  ///< on each axis, of nodes near each other

/// Lanes are below 0 where nodes are farther apart.
[[gnu::always_inline]] inline FourInts far_lanes(FourInts node, FourInts from) noexcept {
  const FourInts apart = node - from;
  return (apart + kMostApart) | (kMostApart - apart);
}

/// Fine lattice coordinates of a voxel grid: nodes are at multiples of 2 `levels`, the levels of an edge at
/// the odd coordinates in between.
class VoxelGrid {
 public:
  /// An edge is told by its lower node.
  using Node = std::array<std::int32_t, 3>;

  /// `levels`: 1 to kMostLevels.
  explicit VoxelGrid(std::uint32_t levels) noexcept
      : voxel_(2 * static_cast<std::int32_t>(levels)),
        one_over_levels_((std::uint64_t{1} << kOneBits) / levels + 1) {}

  /// A vertex in the middle of a level of an edge.
  struct Cut {
    Node node;
    std::size_t axis;
    std::int32_t level;
  };
  std::optional<Cut> cut_of(const Cell& cell) const noexcept;

  /// Lanes 0 to 2 are used. `node`: of the edge, its lower one.
  FourInts cell_of(FourInts node, std::size_t axis, std::int32_t level) const noexcept {
    static constexpr std::array<std::array<std::int32_t, 4>, 3> kAxes = {
        {{-1, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, -1, 0}}};
    return node * voxel_ + ((FourInts{} + (2 * level + 1)) & std::bit_cast<FourInts>(kAxes[axis]));
  }
  /// Distance of a level from the lower end of its edge, parts of a voxel: floor(64 (2 level + 1) / levels).
  std::int16_t part_of(std::int32_t level) const noexcept {
    const std::uint64_t parts = (2 * static_cast<std::uint64_t>(level) + 1) << (kVoxelBits - 1);
    return static_cast<std::int16_t>(parts * one_over_levels_ >> kOneBits);
  }

  std::int32_t voxel() const noexcept { return voxel_; }
  std::int32_t levels() const noexcept { return voxel_ / 2; }

 private:
  std::int32_t voxel_;
  /// Exact where numerator times `levels`, at most 2^45, is below 2^kOneBits.
  static constexpr int kOneBits = 46;
  std::uint64_t one_over_levels_;  ///< a little more than 2^kOneBits of it
};

/// The spot at a node, modulo 2^16.
inline VoxelSpot spot_of(const VoxelGrid::Node& node, std::size_t axis, std::int16_t part) noexcept {
  VoxelSpot spot{};
  for (std::size_t a = 0; a < 3; ++a)
    spot.at[a] = static_cast<std::int16_t>(static_cast<std::uint32_t>(node[a]) << kVoxelBits);
  spot.at[axis] = static_cast<std::int16_t>(spot.at[axis] + part);
  spot.at[3] = static_cast<std::int16_t>(axis << kVoxelBits);
  return spot;
}

}  // namespace deltamesh
