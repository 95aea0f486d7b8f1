// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Vertices on the edges of a voxel grid, as marching cubes makes them: which edges a vertex may be on, given
// those of its neighbours [VOX-2 .. VOX-4].
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "predictive/blend.h"

namespace deltamesh {

/// The middle of a grid edge in half voxels: one coordinate is odd, the edge's axis.
using EdgePlace = std::array<std::int32_t, 3>;

/// Fine lattice coordinates of a voxel grid: a node is a multiple of 2 `levels`, and what an edge is cut into
/// are its odd coordinates in between.
class VoxelGrid {
 public:
  explicit VoxelGrid(std::uint32_t levels) noexcept : voxel_(2 * static_cast<std::int32_t>(levels)) {}

  /// The edge that a cell is on, in the middle of a level; empty where it is not.
  std::optional<EdgePlace> edge_of(const Cell& cell) const noexcept;

  std::int32_t voxel() const noexcept { return voxel_; }
  std::int32_t levels() const noexcept { return voxel_ / 2; }

 private:
  std::int32_t voxel_;
};

constexpr std::size_t axis_of(const EdgePlace& edge) noexcept {
  return (edge[0] & 1) != 0 ? 0 : (edge[1] & 1) != 0 ? 1 : 2;
}

/// The edges of the cubes that a vertex's first face, or neighbour, allows, best first.
class EdgeCandidates {
 public:
  static constexpr unsigned kMost = 4 * 12;  ///< an edge's cubes, their edges

  /// `edges`: of coded vertices, where they have one; `place`: where the vertex is expected, 1/16 fine steps.
  EdgeCandidates(const Surroundings& around, std::span<const std::optional<EdgePlace>> edges,
                 const std::array<std::int64_t, 3>& place, const VoxelGrid& grid) noexcept;

  unsigned size() const noexcept { return size_; }
  /// The candidate of this rank, below size().
  EdgePlace ranked(unsigned rank) const noexcept;
  /// The rank of `edge` where it is below `limit`.
  std::optional<unsigned> rank_of(const EdgePlace& edge, unsigned limit) const noexcept;

  unsigned faces() const noexcept { return face_count_; }  ///< known faces with both corners on edges, to 3
  unsigned likely() const noexcept { return likely_; }     ///< candidates that all known faces allow
  /// How near the best is compared with the next, 0 (much) to 5.
  unsigned doubt() const noexcept;

 private:
  /// Per axis, which odd cube centres are left: those of two neighbours' cubes, or fewer.
  struct CubeRange {
    EdgePlace low;
    EdgePlace high;
  };
  /// A set of a cube's twelve edges.
  using EdgeSet = std::uint16_t;

  static CubeRange cubes_at(const EdgePlace& edge) noexcept;
  static bool intersect(CubeRange& range, const CubeRange& other) noexcept;
  /// Squared distances from where the vertex is expected, per axis, of all places of a range's edges by
  /// ascending place; along an edge's own axis only what is beyond its ends counts.
  using Squares = std::array<std::array<std::int64_t, 5>, 3>;

  Squares squares_of(const CubeRange& range) const noexcept;
  void add_cube(const CubeRange& range, const EdgePlace& center, const Squares& squares) noexcept;
  /// Those of the cube's edges that `range`'s cubes have too.
  static EdgeSet shared_edges(const CubeRange& range, const EdgePlace& center) noexcept;
  /// Those that an earlier cube of `range` has, or a neighbour is on.
  EdgeSet edges_taken(const CubeRange& range, const EdgePlace& center) const noexcept;

  static constexpr std::int64_t kNone = INT64_MAX;

  /// Times kMost and more, plus the edge's number, 12 * cube + edge; those of no candidates are larger.
  std::array<std::int64_t, kMost> scores_;
  std::int64_t best_ = kNone;
  std::int64_t second_ = kNone;
  unsigned size_ = 0;
  std::array<EdgePlace, 4> cubes_;
  unsigned cube_count_ = 0;
  std::array<CubeRange, Surroundings::kMostKnown> faces_;
  unsigned all_faces_ = 0;
  unsigned face_count_ = 0;
  unsigned likely_ = 0;
  std::array<EdgePlace, 2 * Surroundings::kMostKnown> taken_;
  unsigned taken_count_ = 0;
  std::array<std::int64_t, 3> place_;  ///< 1/16 fine steps
  std::int64_t half_;                  ///< half a voxel, 1/16 fine steps
};

}  // namespace deltamesh
