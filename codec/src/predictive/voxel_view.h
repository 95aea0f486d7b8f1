// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The cube that a vertex's first usable face puts it in, and what the vertices around say of where in it
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

/// Edges are told by their numbers after the cube's turn. find(), then choose() where is_open(), then look();
/// what the others tell is known after these.
class VoxelView {
 public:
  /// False where no known face has a cube. `spots`: of the vertices before this one at least.
  bool find(const Surroundings& around, std::span<const VoxelSpot> spots) noexcept;

  /// The vertex may be in two cubes.
  bool is_open() const noexcept { return is_open_; }
  void choose(bool higher) noexcept { cube_ = &pair_->cubes[higher ? 1 : 0]; }
  /// Whether the higher one of two cubes has the edge at a spot.
  bool higher_has(const VoxelSpot& spot) const noexcept;

  /// As given to find().
  void look(const Surroundings& around, std::span<const VoxelSpot> spots, const BlendTable& blends) noexcept;

  /// voxel::kNoEdge where the cube does not have it.
  unsigned number_of(const VoxelSpot& spot) const noexcept;
  /// The edge of this number, below 12.
  unsigned edge_of(unsigned number) const noexcept { return voxel::kBeforeTurn[cube_->turn][number]; }
  /// A spot on it, at this part.
  VoxelSpot spot_on(unsigned edge, std::int16_t part) const noexcept;
  /// From the node of the face's corner a to the edge's, and 0.
  FourInts steps_to(unsigned edge) const noexcept;

  std::uint32_t corner() const noexcept { return corner_; }  ///< the face's corner a
  unsigned kind() const noexcept { return cube_->kind; }     ///< how the face's corners lie, below 6
  unsigned opposite() const noexcept { return opposite_; }   ///< where the face's opposite is in its cube
  unsigned nearest() const noexcept { return nearest_; }     ///< to where the vertex is expected
  unsigned next() const noexcept { return next_; }           ///< after it, or kNoEdge
  unsigned likely() const noexcept { return likely_; }       ///< how many edges the vertices around allow

  /// Where on an edge the neighbours' mean is, from its lower end, parts of a voxel.
  std::int32_t mean_on(unsigned edge) const noexcept { return mean_[edge / 4] + kHalf; }
  /// Where the plane through the face's corners and the expected spot cuts it, likewise.
  std::int32_t plane_on(unsigned edge) const noexcept;

 private:
  static constexpr std::int16_t kHalf = kVoxelParts / 2;
  static constexpr std::int16_t kFar = 3 * kHalf;  ///< from the centre: nothing is expected farther off

  struct Seen;
  EightShorts from_lowest(const VoxelSpot& spot) const noexcept;
  void add(EightShorts a, EightShorts b, std::int32_t repeated, const KnownFace& face,
           std::span<const VoxelSpot> spots, Seen& seen) noexcept;
  EightShorts blend(const Seen& seen, const Surroundings& around, const BlendTable& blends) noexcept;

  const voxel::CubePair* pair_ = nullptr;
  const voxel::PairCube* cube_ = nullptr;
  std::uint32_t corner_ = 0;
  std::uint32_t face_ = 0;  ///< of the known ones
  bool is_open_ = false;
  unsigned opposite_ = voxel::kNoEdge;
  unsigned nearest_ = 0;
  unsigned next_ = 0;
  unsigned likely_ = 0;
  unsigned neighbors_ = 0;
  EightShorts node_{};    ///< of the face's corner a, as a spot
  EightShorts lowest_{};  ///< the cube's lowest node, likewise
  EightShorts mean_{};    ///< from the cube's centre, parts of a voxel
  EightShorts corner_spot_{};
  FourInts normal_{};
};

}  // namespace deltamesh
