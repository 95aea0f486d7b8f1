// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The cube that a vertex's first known face puts it in, and what the vertices around say of where in it
// [VOX-2, VOX-3]. Integers only; shared by writer and reader.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "predictive/blend.h"
#include "predictive/voxel_edges.h"
#include "predictive/voxel_lanes.h"
#include "predictive/voxel_tables.h"

namespace deltamesh {

/// Edges are told by their numbers after the cube's turn. find(), then choose() where is_open(), then look().
class VoxelView {
 public:
  /// False where no known face has a cube. `vertices`: of them, those before the vertex are known.
  bool find(const Surroundings& around, std::span<const VoxelVertex> vertices) noexcept;

  /// The vertex may be in two cubes.
  bool is_open() const noexcept { return is_open_; }
  void choose(bool higher) noexcept;
  /// Whether the higher one of two cubes has an edge.
  bool higher_has(const VoxelVertex& vertex) const noexcept;

  void look(const Surroundings& around, std::span<const VoxelVertex> vertices,
            const BlendTable& blends) noexcept;

  /// voxel::kNoEdge where the cube does not have it.
  unsigned number_of(const VoxelVertex& vertex) const noexcept;
  /// The cube's edge of this number, below 12, but for where on it; its axis.
  std::size_t edge_of(unsigned number, VoxelVertex& vertex) const noexcept;

  unsigned kind() const noexcept { return kind_; }          ///< how the face's corners lie, below 6
  unsigned opposite() const noexcept { return opposite_; }  ///< where the face's opposite is in its cube
  unsigned nearest() const noexcept { return nearest_; }    ///< to where the vertex is expected
  unsigned next() const noexcept { return next_; }          ///< the next after it
  unsigned likely() const noexcept { return likely_; }      ///< how many edges all neighbours allow
  unsigned neighbors() const noexcept { return neighbors_; }

  /// Where on an edge along `axis` the neighbours' mean is, from its lower end, 64ths of half a voxel.
  std::int32_t mean_along(std::size_t axis) const noexcept { return mean_[axis] + kHalf; }
  /// Where the plane through the face's corners and the expected place cuts the edge of `vertex`, likewise.
  std::int32_t plane_along(std::size_t axis, const VoxelVertex& vertex) const noexcept;

 private:
  static constexpr std::int16_t kHalf = 64;        ///< parts of half a voxel
  static constexpr std::int16_t kFar = 3 * kHalf;  ///< from the centre: farther is not looked at
  static constexpr std::int16_t kClosed = 0x7fff;  ///< score of an edge that is out of question

  EightShorts place_of(const VoxelVertex& vertex, EightShorts steps) const noexcept;
  void settle(const voxel::CubePair& pair, bool higher) noexcept;
  void rank(EightShorts expected, unsigned allowed) noexcept;

  FourInts center_{};  ///< half voxels
  FourInts first_{};   ///< the first corner of the face
  const voxel::CubePair* pair_ = nullptr;
  const VoxelVertex* a_ = nullptr;
  const VoxelVertex* b_ = nullptr;
  const VoxelVertex* opposite_vertex_ = nullptr;
  bool is_open_ = false;
  unsigned turn_ = 0;
  unsigned kind_ = 0;
  unsigned opposite_ = voxel::kNoEdge;
  unsigned nearest_ = 0;
  unsigned next_ = 0;
  unsigned likely_ = 0;
  unsigned neighbors_ = 0;
  /// From the cube's centre, 64ths of half a voxel.
  EightShorts mean_{};
  EightShorts expected_{};
  EightShorts place_a_{};
  EightShorts place_b_{};
};

}  // namespace deltamesh
