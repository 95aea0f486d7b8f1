// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The cubes in which two vertices lie, by their known faces [VOX-2]. Integers only; shared by writer and
// reader.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "positions/grid/edges.h"
#include "positions/grid/faces.h"
#include "positions/grid/lanes.h"
#include "positions/grid/tables.h"

namespace deltamesh {

namespace voxel {

/// Masks of the lanes of a spot that hold its node,
inline constexpr EightShorts kNodes = {-kVoxelParts, -kVoxelParts, -kVoxelParts, 0,
                                       -kVoxelParts, -kVoxelParts, -kVoxelParts, 0};
/// and of the lane that holds its axis.
inline constexpr EightShorts kAxes = {0, 0, 0, -1, 0, 0, 0, -1};

/// For both halves: the cubes that the edges of spots `a` and `b` share; `nodes`: those of `a`, near those of
/// `b`.
[[gnu::always_inline]] inline std::array<const CubePair*, 2> pairs_of(EightShorts a, EightShorts nodes,
                                                                      EightShorts b) noexcept {
  const EightShorts apart = wrapped_difference(b, nodes);
  const auto sums = weigh((apart + (a & kAxes) * 3) >> kVoxelBits, kPairWeights);
  std::array<const CubePair*, 2> pairs{};
  for (std::size_t i = 0; i < 2; ++i)
    pairs[i] = &kPairTable.pairs[kPairTable.places[static_cast<std::size_t>(sums[i] + kPairMiddle)]];
  return pairs;
}

}  // namespace voxel

/// Spots and nodes of all vertices. Those of vertices that are not coded yet are not read.
struct VoxelPlaces {
  std::span<const VoxelSpot> spots;
  std::span<const FourInts> nodes;
};

/// The known faces that a vertex is predicted from.
struct VoxelCorners {
  VoxelFaces::Star
      star;  ///< corners a and b of the first known face, then of the last, which may be the same
  std::uint32_t
      opposite;  ///< the vertex across the first face's a and b; VoxelFaces::none() unless it is near a
};

/// Corner k of both vertices' stars, in a half each.
[[gnu::always_inline]] inline EightShorts corner_spots(const std::array<VoxelCorners, 2>& corners,
                                                       std::span<const VoxelSpot> spots,
                                                       std::size_t k) noexcept {
  return load_two(spots[corners[0].star[k]].at, spots[corners[1].star[k]].at);
}

/// One cube for each of two vertices, which are numbered 0 and 1.
class VoxelCubes {
 public:
  /// Empty if a corner of a face is not near the first one, or if the edges of a first face's a and b share
  /// no cube.
  [[gnu::always_inline]] static std::optional<VoxelCubes> find(const std::array<VoxelCorners, 2>& corners,
                                                               const VoxelPlaces& places) noexcept;

  /// `pairs`: of the edges of `corners`' first faces, each of one or two cubes, as find() makes
  /// sure; `nodes`: of their corners a.
  VoxelCubes(const std::array<const voxel::CubePair*, 2>& pairs, EightShorts nodes,
             const std::array<VoxelCorners, 2>& corners, std::span<const VoxelSpot> spots) noexcept
      : pairs_(pairs), nodes_(halves_of(nodes)) {
    for (std::size_t i = 0; i < 2; ++i) choose(i, spots[corners[i].opposite]);
  }

  /// The same with vertex i, which is open, in the higher one of its two cubes.
  VoxelCubes with_higher(std::size_t i) const noexcept {
    VoxelCubes result = *this;
    result.cubes_[i] = &pairs_[i]->cubes[1];
    result.is_open_[i] = 0;
    return result;
  }

  /// True if the vertex may be in either of two cubes. It is taken to be in the lower one.
  bool is_open(std::size_t i) const noexcept { return is_open_[i] != 0; }
  const voxel::PairCube& cube(std::size_t i) const noexcept { return *cubes_[i]; }
  /// The other one of two cubes, or the same one.
  const voxel::PairCube& other(std::size_t i) const noexcept {
    return pairs_[i]->cubes[cubes_[i] == &pairs_[i]->cubes[0] ? 1 : 0];
  }
  const voxel::PairCube& higher(std::size_t i) const noexcept { return pairs_[i]->cubes[1]; }
  /// The node of the first face's corner a, as a spot.
  const FourShorts& node(std::size_t i) const noexcept { return nodes_[i]; }

 private:
  void choose(std::size_t i, const VoxelSpot& opposite) noexcept;

  std::array<const voxel::CubePair*, 2> pairs_;
  std::array<const voxel::PairCube*, 2> cubes_{};
  std::array<unsigned, 2> is_open_{};
  std::array<FourShorts, 2> nodes_;
};

[[gnu::always_inline]] inline std::optional<VoxelCubes> VoxelCubes::find(
    const std::array<VoxelCorners, 2>& corners, const VoxelPlaces& places) noexcept {
  FourInts far{};
  for (const VoxelCorners& around : corners) {
    const FourInts first = places.nodes[around.star[0]];
    far |= first;  // below 0 where it is on no edge
    for (std::size_t k = 1; k < 4; ++k) far |= far_lanes(places.nodes[around.star[k]], first);
  }
  std::optional<VoxelCubes> found;
  if (set_lanes(far) != 0) return found;
  const EightShorts a = corner_spots(corners, places.spots, 0);
  const EightShorts nodes = a & voxel::kNodes;
  const auto pairs = voxel::pairs_of(a, nodes, corner_spots(corners, places.spots, 1));
  if (pairs[0]->count != 0 && pairs[1]->count != 0) found.emplace(pairs, nodes, corners, places.spots);
  return found;
}

/// Of two cubes, takes the one that the opposite is not in.
[[gnu::always_inline]] inline void VoxelCubes::choose(std::size_t i, const VoxelSpot& opposite) noexcept {
  const voxel::CubePair& pair = *pairs_[i];
  const std::int32_t off = opposite.at[pair.axis] - nodes_[i][pair.axis] - pair.between;
  const std::int32_t side = opposite.on_edge() ? static_cast<std::int16_t>(off) : 0;
  cubes_[i] = &pair.cubes[side < 0 ? 1 : 0];
  is_open_[i] = (side == 0 ? 1U : 0U) & (pair.count >> 1);
}

}  // namespace deltamesh
