// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What the corners around two vertices say of the edges they are on, and of the places on these [VOX-3,
// VOX-4, VOX-6]. Integers only; shared by writer and reader.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "positions/grid/cubes.h"
#include "positions/grid/edges.h"
#include "positions/grid/lanes.h"
#include "positions/grid/tables.h"

namespace deltamesh {

namespace voxel {

/// Spots relative to a cube's lowest node, clamped to the range of near_index(): a vertex on no edge may be
/// anywhere.
[[gnu::always_inline]] inline EightShorts cut(EightShorts from_lowest) noexcept {
  return clamp(from_lowest, -kBelow * kVoxelParts, kAbove * kVoxelParts);
}

/// near_index() of two spots relative to their cubes' lowest nodes.
[[gnu::always_inline]] inline std::array<std::size_t, 2> places_near(EightShorts spots) noexcept {
  const auto sums = weigh(spots >> kVoxelBits, kNearWeights);
  return {static_cast<std::size_t>(sums[0] + kNearMiddle), static_cast<std::size_t>(sums[1] + kNearMiddle)};
}

}  // namespace voxel

/// Two vertices, numbered 0 and 1, in one cube each. An edge's number is the one that the cube's rotation
/// gives it.
class VoxelPair {
 public:
  static constexpr unsigned kOpen = 13;        ///< opposite() of an open vertex
  static constexpr std::int16_t kPlaces = 20;  ///< places on an edge, including some before and after it
  static constexpr std::int32_t kMiddlePlace = 10;

  /// `cubes`: must outlive the pair; `corners`: those that they were found with; `spots`: of all vertices.
  VoxelPair(const VoxelCubes& cubes, const std::array<VoxelCorners, 2>& corners,
            std::span<const VoxelSpot> spots) noexcept;

  /// VoxelCubes::is_open().
  bool is_open(std::size_t i) const noexcept { return cubes_->is_open(i); }
  /// Whether the higher one of two cubes has the edge of a spot that is near the first corner.
  bool higher_has(std::size_t i, const VoxelSpot& spot) const noexcept {
    return edge_at(i, cubes_->higher(i), spot) != voxel::kNoEdge;
  }

  /// Number of the edge of a spot that is near the first corner; voxel::kNoEdge if the cube does not have the
  /// edge.
  unsigned number_of(std::size_t i, const VoxelSpot& spot) const noexcept {
    return voxel::kRotated[cubes_->cube(i).rotation][edge_at(i, cubes_->cube(i), spot)];
  }
  /// The edge with this number, which is below 12.
  unsigned edge_of(std::size_t i, unsigned number) const noexcept {
    return voxel::kBeforeRotation[cubes_->cube(i).rotation][number];
  }
  /// The spot at a part of a voxel from the edge's lower node.
  VoxelSpot spot_on(std::size_t i, unsigned edge, std::int16_t part) const noexcept;
  /// The edge's node minus the node of the first face's corner a; the last lane is 0.
  FourInts steps_to(std::size_t i, unsigned edge) const noexcept {
    const EightShorts spot = load_one(cubes_->cube(i).lowest) + load_one(voxel::kEdgeSpots[edge]);
    return low_ints((spot & voxel::kNodes) >> kVoxelBits);
  }

  unsigned kind(std::size_t i) const noexcept { return cubes_->cube(i).kind; }  ///< below 6 [VOX-2]
  /// The edges that the corners around allow: bit e for the edge with number e.
  unsigned likely(std::size_t i) const noexcept { return likely_[i]; }
  /// Number of the opposite's edge, voxel::kNoEdge or kOpen.
  unsigned opposite(std::size_t i) const noexcept { return opposites_[i]; }

  /// Place of the corners' mean on an edge, below kPlaces.
  std::int32_t mean_on(std::size_t i, unsigned edge) const noexcept { return means_[i][edge / 4]; }
  /// Place, below kPlaces, where the plane through the first face's corners and the expected spot cuts the
  /// edge.
  std::int32_t plane_on(std::size_t i, unsigned edge) const noexcept;

 private:
  /// Distance of place 0 from an edge's middle, parts of a voxel.
  static constexpr std::int16_t kFirstPlace = kVoxelMiddle + kVoxelParts / 8;

  unsigned edge_at(std::size_t i, const voxel::PairCube& cube, const VoxelSpot& spot) const noexcept {
    const EightShorts lowest = wrapped_sum(load_one(cubes_->node(i)), load_one(cube.lowest));
    return voxel::kEdgeAt[voxel::places_near(wrapped_difference(load_one(spot.at), lowest))[0]];
  }
  void expect(EightShorts a, EightShorts b, EightShorts last_a, EightShorts last_b,
              EightShorts opposite) noexcept;

  const VoxelCubes* cubes_;
  std::array<unsigned, 2> likely_{};
  std::array<unsigned, 2> opposites_{};
  std::array<FourShorts, 2> lowest_{};    ///< the cubes' lowest nodes, as spots
  std::array<FourShorts, 2> means_{};     ///< places, by axis
  std::array<FourInts, 2> normals_{};     ///< of the planes of plane_on()
  std::array<std::int32_t, 2> planes_{};  ///< products of the normals and the corners a
};

[[gnu::always_inline]] inline VoxelPair::VoxelPair(const VoxelCubes& cubes,
                                                   const std::array<VoxelCorners, 2>& corners,
                                                   std::span<const VoxelSpot> spots) noexcept
    : cubes_(&cubes) {
  const auto corner = [&](std::size_t k) { return corner_spots(corners, spots, k); };
  const EightShorts opposite = load_two(spots[corners[0].opposite].at, spots[corners[1].opposite].at);
  const EightShorts nodes = load_two(cubes.node(0), cubes.node(1));
  const EightShorts lowest = wrapped_sum(nodes, load_two(cubes.cube(0).lowest, cubes.cube(1).lowest));
  const EightShorts across = wrapped_sum(nodes, load_two(cubes.other(0).lowest, cubes.other(1).lowest));
  const EightShorts last_a = wrapped_difference(corner(2), lowest);
  const EightShorts last_b = wrapped_difference(corner(3), lowest);
  lowest_ = halves_of(lowest);
  const auto places_a = voxel::places_near(last_a);
  const auto places_b = voxel::places_near(last_b);
  const auto places_across = voxel::places_near(voxel::cut(wrapped_difference(opposite, across)));
  for (std::size_t i = 0; i < 2; ++i) {
    const voxel::PairCube& cube = cubes.cube(i);
    const unsigned set = cube.others & voxel::kEdgesNear[places_a[i]] & voxel::kEdgesNear[places_b[i]];
    likely_[i] = voxel::rotated_set(cube.rotation, set);
    const unsigned number = voxel::kRotated[cube.rotation][voxel::kEdgeAt[places_across[i]]];
    opposites_[i] = cubes.is_open(i) ? kOpen : number;
  }
  expect(wrapped_difference(corner(0), lowest) - kVoxelMiddle,
         wrapped_difference(corner(1), lowest) - kVoxelMiddle, last_a - kVoxelMiddle, last_b - kVoxelMiddle,
         opposite);
}

/// `a` to `last_b`: the corners' spots relative to the cubes' centres; `opposite`: its spot.
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
