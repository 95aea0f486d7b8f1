// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Edges of a voxel grid, on which marching cubes puts vertices, and levels on them [VOX-1, VOX-6].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "base/four_ints.h"
#include "predictive/blend.h"

namespace deltamesh {

/// A vertex on a grid edge, or not.
struct VoxelVertex {
  /// The middle of the edge in half voxels: one coordinate is odd, the edge's axis. In the last lane the axis
  /// and where on the edge the vertex is, or kOff.
  FourInts place{0, 0, 0, kOff};

  static constexpr std::int32_t kOff = -1;
  static constexpr std::int32_t form_of(std::size_t axis, std::int32_t along) noexcept {
    return static_cast<std::int32_t>(axis) << 8 | along;
  }
  bool on_edge() const noexcept { return place[3] >= 0; }
  std::size_t axis() const noexcept { return static_cast<std::size_t>(place[3] >> 8); }
  /// From the edge's lower end, 64ths of half a voxel: 0 to 127.
  std::int16_t along() const noexcept { return static_cast<std::int16_t>(place[3] & 0xff); }
};

/// Fine lattice coordinates of a voxel grid: a node is a multiple of 2 `levels`, and what an edge is cut into
/// are its odd coordinates in between.
class VoxelGrid {
 public:
  /// `levels`: 1 to kMostLevels.
  explicit VoxelGrid(std::uint32_t levels) noexcept
      : voxel_(2 * static_cast<std::int32_t>(levels)), one_over_levels_((std::uint64_t{1} << 32) / levels) {}

  /// Where a cell is in the middle of a level of an edge, and the level.
  struct Cut {
    VoxelVertex vertex;
    std::int32_t level;
  };
  std::optional<Cut> cut_of(const Cell& cell) const noexcept;

  /// Sets the last lane of `vertex`, and gives the cell.
  Cell cut(VoxelVertex& vertex, std::size_t axis, std::int32_t level) const noexcept {
    const auto along = (2 * static_cast<std::uint64_t>(level) + 1) * one_over_levels_ >> 26;
    vertex.place[3] = VoxelVertex::form_of(axis, static_cast<std::int32_t>(along));
    Cell cell;
    for (std::size_t a = 0; a < 3; ++a) cell[a] = (vertex.place[a] >> 1) * voxel_;
    cell[axis] += 2 * level + 1;
    return cell;
  }

  std::int32_t voxel() const noexcept { return voxel_; }
  std::int32_t levels() const noexcept { return voxel_ / 2; }

 private:
  std::int32_t voxel_;
  std::uint64_t one_over_levels_;  ///< 2^32 of it, rounded down
};

}  // namespace deltamesh
