// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The cubes that two vertices' first faces put them in, and what the corners around say of where in these
// [VOX-2, VOX-3]. Integers only; shared by writer and reader.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "predictive/voxel_edges.h"
#include "predictive/voxel_faces.h"
#include "predictive/voxel_lanes.h"
#include "predictive/voxel_tables.h"

namespace deltamesh {

namespace voxel {

/// Bits of a spot's node.
inline constexpr EightShorts kNodes = {-kVoxelParts, -kVoxelParts, -kVoxelParts, 0,
                                       -kVoxelParts, -kVoxelParts, -kVoxelParts, 0};
/// Those of its axis.
inline constexpr EightShorts kAxes = {0, 0, 0, -1, 0, 0, 0, -1};

/// Spots from a cube's lowest node, as far off as tables go: for those on no edge, which are anywhere.
[[gnu::always_inline]] inline EightShorts cut(EightShorts from_lowest) noexcept {
  return clamp(from_lowest, -kBelow * kVoxelParts, kAbove * kVoxelParts);
}

/// Of two spots from cubes' lowest nodes: by near_index().
[[gnu::always_inline]] inline std::array<std::size_t, 2> places_near(EightShorts spots) noexcept {
  const auto sums = weigh(spots >> kVoxelBits, kNearWeights);
  return {static_cast<std::size_t>(sums[0] + kNearMiddle), static_cast<std::size_t>(sums[1] + kNearMiddle)};
}

/// The cubes of the edges of `a` and `b`, which are near each other, for both halves; `nodes`: of a.
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

/// Where all vertices are. Of what is not there yet nothing is asked.
struct VoxelPlaces {
  std::span<const VoxelSpot> spots;
  std::span<const FourInts> nodes;
};

/// The faces that a vertex is seen by.
struct VoxelCorners {
  VoxelFaces::Star
      star;  ///< corners a and b of the face that tells the cube, then of another or the same one
  std::uint32_t opposite;  ///< across the first one's a and b; on no edge where it is not near a
};

/// Two vertices, told by 0 and 1. Edges are told by their numbers after the cube's rotation. find(), then
/// look(); where is_open(), choose() and look() again.
class VoxelPair {
 public:
  static constexpr unsigned kOpen = 13;        ///< in place of where the opposite is
  static constexpr std::int16_t kPlaces = 20;  ///< along an edge, and a little before and after it
  static constexpr std::int32_t kMiddlePlace = 10;

  /// False where a corner of a face is not near the first one, or a first face has no cube.
  bool find(const std::array<VoxelCorners, 2>& corners, const VoxelPlaces& places) noexcept;
  /// As given to find().
  void look(const std::array<VoxelCorners, 2>& corners, std::span<const VoxelSpot> spots) noexcept;

  /// The vertex may be in two cubes, and is taken to be in the lower one.
  bool is_open(std::size_t i) const noexcept { return is_open_[i] != 0; }
  /// The higher one of two.
  void choose(std::size_t i) noexcept {
    cubes_[i] = &pairs_[i]->cubes[1];
    is_open_[i] = 0;
  }
  /// Whether the higher one of two cubes has the edge of a spot that is near the first corner.
  bool higher_has(std::size_t i, const VoxelSpot& spot) const noexcept {
    return edge_at(i, pairs_[i]->cubes[1], spot) != voxel::kNoEdge;
  }

  /// Of a spot that is near the first corner; voxel::kNoEdge where the cube does not have its edge.
  unsigned number_of(std::size_t i, const VoxelSpot& spot) const noexcept {
    return voxel::kRotated[cubes_[i]->rotation][edge_at(i, *cubes_[i], spot)];
  }
  /// The edge of this number, below 12.
  unsigned edge_of(std::size_t i, unsigned number) const noexcept {
    return voxel::kBeforeRotation[cubes_[i]->rotation][number];
  }
  /// A spot on it, at this part.
  VoxelSpot spot_on(std::size_t i, unsigned edge, std::int16_t part) const noexcept;
  /// From the node of the first face's corner a to the edge's, and 0.
  FourInts steps_to(std::size_t i, unsigned edge) const noexcept {
    const EightShorts spot = load_one(cubes_[i]->lowest) + load_one(voxel::kEdgeSpots[edge]);
    return low_ints((spot & voxel::kNodes) >> kVoxelBits);
  }

  unsigned kind(std::size_t i) const noexcept { return cubes_[i]->kind; }  ///< how a and b lie, below 6
  /// The edges that the corners around allow, bit by bit.
  unsigned likely(std::size_t i) const noexcept { return likely_[i]; }
  /// Where the opposite is: an edge, voxel::kNoEdge or kOpen.
  unsigned opposite(std::size_t i) const noexcept { return opposites_[i]; }

  /// Where on an edge the corners' mean is, below kPlaces.
  std::int32_t mean_on(std::size_t i, unsigned edge) const noexcept { return means_[i][edge / 4]; }
  /// Where the plane through the first face's corners and the expected spot cuts it, likewise.
  std::int32_t plane_on(std::size_t i, unsigned edge) const noexcept;

 private:
  /// From an edge's middle down to where places begin, parts of a voxel.
  static constexpr std::int16_t kFirstPlace = kVoxelMiddle + kVoxelParts / 8;

  unsigned edge_at(std::size_t i, const voxel::PairCube& cube, const VoxelSpot& spot) const noexcept {
    const EightShorts lowest = wrapped_sum(load_one(nodes_[i]), load_one(cube.lowest));
    return voxel::kEdgeAt[voxel::places_near(wrapped_difference(load_one(spot.at), lowest))[0]];
  }
  void choose_by(std::size_t i, const VoxelSpot& opposite) noexcept;
  void expect(EightShorts a, EightShorts b, EightShorts last_a, EightShorts last_b,
              EightShorts opposite) noexcept;

  std::array<const voxel::CubePair*, 2> pairs_;
  std::array<const voxel::PairCube*, 2> cubes_;
  std::array<unsigned, 2> is_open_;
  std::array<unsigned, 2> likely_;
  std::array<unsigned, 2> opposites_;
  std::array<FourShorts, 2> nodes_;   ///< of the first faces' corners a, as spots
  std::array<FourShorts, 2> lowest_;  ///< the cubes' lowest nodes, likewise
  std::array<FourShorts, 2> means_;   ///< places
  std::array<FourInts, 2> normals_;
  std::array<std::int32_t, 2> planes_;  ///< the normals times the corners a
};

/// Corner k of both vertices' stars, in a half each.
[[gnu::always_inline]] inline EightShorts corner_spots(const std::array<VoxelCorners, 2>& corners,
                                                       std::span<const VoxelSpot> spots,
                                                       std::size_t k) noexcept {
  return load_two(spots[corners[0].star[k]].at, spots[corners[1].star[k]].at);
}

[[gnu::always_inline]] inline bool VoxelPair::find(const std::array<VoxelCorners, 2>& corners,
                                                   const VoxelPlaces& places) noexcept {
  FourInts far{};
  for (const VoxelCorners& around : corners) {
    const FourInts first = places.nodes[around.star[0]];
    far |= first;  // below 0 where it is on no edge
    for (std::size_t k = 1; k < 4; ++k) far |= far_lanes(places.nodes[around.star[k]], first);
  }
  if (set_lanes(far) != 0) return false;
  const EightShorts a = corner_spots(corners, places.spots, 0);
  const EightShorts nodes = a & voxel::kNodes;
  nodes_ = halves_of(nodes);
  pairs_ = voxel::pairs_of(a, nodes, corner_spots(corners, places.spots, 1));
  if (pairs_[0]->count == 0 || pairs_[1]->count == 0) return false;
  for (std::size_t i = 0; i < 2; ++i) choose_by(i, places.spots[corners[i].opposite]);
  return true;
}

/// Where the face across is in one of two cubes this one is in the other.
[[gnu::always_inline]] inline void VoxelPair::choose_by(std::size_t i, const VoxelSpot& opposite) noexcept {
  const voxel::CubePair& pair = *pairs_[i];
  const std::int32_t off = opposite.at[pair.axis] - nodes_[i][pair.axis] - pair.between;
  const std::int32_t side = opposite.on_edge() ? static_cast<std::int16_t>(off) : 0;
  cubes_[i] = &pair.cubes[side < 0 ? 1 : 0];
  is_open_[i] = (side == 0 ? 1U : 0U) & (pair.count >> 1);
}

[[gnu::always_inline]] inline void VoxelPair::look(const std::array<VoxelCorners, 2>& corners,
                                                   std::span<const VoxelSpot> spots) noexcept {
  const auto corner = [&](std::size_t k) { return corner_spots(corners, spots, k); };
  const EightShorts opposite = load_two(spots[corners[0].opposite].at, spots[corners[1].opposite].at);
  const EightShorts nodes = load_two(nodes_[0], nodes_[1]);
  const EightShorts lowest = wrapped_sum(nodes, load_two(cubes_[0]->lowest, cubes_[1]->lowest));
  const auto cubes_across = [&](std::size_t i) -> const FourShorts& {
    return pairs_[i]->cubes[cubes_[i] == &pairs_[i]->cubes[0] ? 1 : 0].lowest;
  };
  const EightShorts across = wrapped_sum(nodes, load_two(cubes_across(0), cubes_across(1)));
  const EightShorts last_a = wrapped_difference(corner(2), lowest);
  const EightShorts last_b = wrapped_difference(corner(3), lowest);
  lowest_ = halves_of(lowest);
  const auto places_a = voxel::places_near(last_a);
  const auto places_b = voxel::places_near(last_b);
  const auto places_across = voxel::places_near(voxel::cut(wrapped_difference(opposite, across)));
  for (std::size_t i = 0; i < 2; ++i) {
    const voxel::PairCube& cube = *cubes_[i];
    const unsigned set = cube.others & voxel::kEdgesNear[places_a[i]] & voxel::kEdgesNear[places_b[i]];
    likely_[i] = voxel::rotated_set(cube.rotation, set);
    const unsigned number = voxel::kRotated[cube.rotation][voxel::kEdgeAt[places_across[i]]];
    opposites_[i] = is_open_[i] != 0 ? kOpen : number;
  }
  expect(wrapped_difference(corner(0), lowest) - kVoxelMiddle,
         wrapped_difference(corner(1), lowest) - kVoxelMiddle, last_a - kVoxelMiddle, last_b - kVoxelMiddle,
         opposite);
}

/// Corners from the cubes' centres; `opposite` as it is.
[[gnu::always_inline]] inline void VoxelPair::expect(EightShorts a, EightShorts b, EightShorts last_a,
                                                     EightShorts last_b, EightShorts opposite) noexcept {
  const EightShorts lowest = load_two(lowest_[0], lowest_[1]);
  const EightShorts mean = (a + b + last_a + last_b) >> 2;
  const EightShorts across = voxel::cut(wrapped_difference(opposite, lowest)) - kVoxelMiddle;
  const EightShorts beyond = (a + b - across - mean) & (last_of_half(opposite) < VoxelSpot::kNoAxis);
  const EightShorts expected = mean + ((beyond * 5) >> 3);
  means_ = halves_of(clamp((mean + kFirstPlace) >> 3, 0, kPlaces - 1));
  // Differences are below 2^7 in b - a and below 2^10 in the other.
  normals_ = cross(b - a, expected - a);
  const std::array<FourShorts, 2> from = halves_of(a);
  for (std::size_t i = 0; i < 2; ++i)
    planes_[i] = normals_[i][0] * from[i][0] + normals_[i][1] * from[i][1] + normals_[i][2] * from[i][2];
}

inline VoxelSpot VoxelPair::spot_on(std::size_t i, unsigned edge, std::int16_t part) const noexcept {
  static constexpr std::array<FourShorts, 3> kAlong = {{{-1, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, -1, 0}}};
  const EightShorts along = (EightShorts{} + part) & load_one(kAlong[edge / 4]);
  const EightShorts spot = wrapped_sum(load_one(lowest_[i]), load_one(voxel::kEdgeSpots[edge]) + along);
  return {halves_of(spot)[0]};
}

inline std::int32_t VoxelPair::plane_on(std::size_t i, unsigned edge) const noexcept {
  const FourInts& normal = normals_[i];
  const std::int32_t steep = normal[static_cast<int>(edge / 4)];
  const voxel::Nodes& middle = voxel::kEdgeMiddles[edge];
  const std::int32_t at_middle = normal[0] * middle[0] + normal[1] * middle[1] + normal[2] * middle[2];
  const std::int32_t below = (at_middle - planes_[i]) / (steep != 0 ? steep : 1);
  return std::clamp((kFirstPlace - below) >> 3, 0, kPlaces - 1);
}

}  // namespace deltamesh
