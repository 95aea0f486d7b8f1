// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "predictive/voxel_edges.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace deltamesh {
namespace {

/// The twelve edges of a cube from its centre, in half voxels.
constexpr std::array<EdgePlace, 12> kCubeEdges = [] {
  std::array<EdgePlace, 12> edges{};
  std::size_t i = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::int32_t corner = 0; corner < 4; ++corner) {
      edges[i][(axis + 1) % 3] = 2 * (corner % 2) - 1;
      edges[i][(axis + 2) % 3] = 2 * (corner / 2) - 1;
      ++i;
    }
  }
  return edges;
}();

/// By axis and offset + 1: the edges with that offset on that axis.
constexpr std::array<std::array<std::uint16_t, 3>, 3> kEdgesAt = [] {
  std::array<std::array<std::uint16_t, 3>, 3> sets{};
  for (std::size_t i = 0; i < kCubeEdges.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      sets[axis][static_cast<std::size_t>(kCubeEdges[i][axis] + 1)] |= static_cast<std::uint16_t>(1U << i);
  return sets;
}();

constexpr std::uint16_t kAllEdges = 0xfff;
constexpr std::int64_t kNumbers = 64;  ///< room for a candidate's number below its score

constexpr std::int64_t kForbidden = std::int64_t{1} << 50;  ///< added for each face that a candidate breaks
constexpr std::int64_t kFarthest = std::int64_t{1} << 22;   ///< distances per axis are cut here

}  // namespace

std::optional<EdgePlace> VoxelGrid::edge_of(const Cell& cell) const noexcept {
  EdgePlace edge{};
  unsigned free_axes = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int32_t node = cell[axis] / voxel_;
    const std::int32_t rest = cell[axis] % voxel_;
    if (rest != 0 && rest % 2 == 0) return std::nullopt;
    free_axes += rest != 0 ? 1 : 0;
    edge[axis] = 2 * node + (rest != 0 ? 1 : 0);
  }
  if (free_axes != 1) return std::nullopt;
  return edge;
}

EdgeCandidates::CubeRange EdgeCandidates::cubes_at(const EdgePlace& edge) noexcept {
  CubeRange range{edge, edge};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if ((edge[axis] & 1) != 0) continue;
    range.low[axis] = edge[axis] - 1;
    range.high[axis] = edge[axis] + 1;
  }
  return range;
}

bool EdgeCandidates::intersect(CubeRange& range, const CubeRange& other) noexcept {
  bool some = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    range.low[axis] = std::max(range.low[axis], other.low[axis]);
    range.high[axis] = std::min(range.high[axis], other.high[axis]);
    some = some && range.low[axis] <= range.high[axis];
  }
  return some;
}

EdgeCandidates::EdgeSet EdgeCandidates::shared_edges(const CubeRange& range,
                                                     const EdgePlace& center) noexcept {
  unsigned shared = kAllEdges;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    unsigned within = 0;
    for (std::int32_t offset = -1; offset <= 1; ++offset) {
      const std::int32_t x = center[axis] + offset;
      if (x >= range.low[axis] - 1 && x <= range.high[axis] + 1)
        within |= kEdgesAt[axis][static_cast<std::size_t>(offset + 1)];
    }
    shared &= within;
  }
  return static_cast<EdgeSet>(shared);
}

EdgeCandidates::EdgeSet EdgeCandidates::edges_taken(const CubeRange& range,
                                                    const EdgePlace& center) const noexcept {
  unsigned taken = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (center[axis] > range.low[axis]) taken |= kEdgesAt[axis][0];
  for (unsigned i = 0; i < taken_count_; ++i) {
    unsigned edge = kAllEdges;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::int32_t offset = taken_[i][axis] - center[axis] + 1;
      edge &= offset >= 0 && offset <= 2 ? kEdgesAt[axis][static_cast<std::size_t>(offset)] : 0U;
    }
    taken |= edge;
  }
  return static_cast<EdgeSet>(taken);
}

void EdgeCandidates::add_cube(const CubeRange& range, const EdgePlace& center) noexcept {
  // Squared distances per axis, by offset; along an edge's own axis only what is beyond its ends counts.
  std::array<std::array<std::int64_t, 3>, 3> squares;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::int32_t offset = -1; offset <= 1; ++offset) {
      std::int64_t off = std::llabs(place_[axis] - half_ * (center[axis] + offset));
      if (offset == 0) off = std::max<std::int64_t>(off - half_, 0);
      off = std::min(off, kFarthest);
      squares[axis][static_cast<std::size_t>(offset + 1)] = off * off;
    }
  }
  std::array<EdgeSet, 8> shared;
  for (unsigned f = 0; f < all_faces_; ++f) shared[f] = shared_edges(faces_[f], center);
  const std::size_t cube = cube_count_++;
  cubes_[cube] = center;
  for (unsigned open = kAllEdges & ~edges_taken(range, center); open != 0; open &= open - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(open));
    const EdgePlace& offset = kCubeEdges[i];
    unsigned broken = 0;
    for (unsigned f = 0; f < all_faces_; ++f) broken += (shared[f] >> i & 1) == 0 ? 1 : 0;
    likely_ += broken == 0 ? 1 : 0;
    std::int64_t score = kForbidden * broken;
    for (std::size_t axis = 0; axis < 3; ++axis)
      score += squares[axis][static_cast<std::size_t>(offset[axis] + 1)];
    places_[size_] = static_cast<std::uint8_t>(12 * cube + i);
    scores_[size_] = score * kNumbers + size_;
    ++size_;
  }
}

EdgeCandidates::EdgeCandidates(const FaceStars& stars, std::uint32_t vertex, const Surroundings& around,
                               std::span<const std::optional<EdgePlace>> edges,
                               const std::array<std::int64_t, 3>& place, const VoxelGrid& grid) noexcept
    : place_(place), half_(std::int64_t{8} * grid.voxel()) {
  for (unsigned i = 0; i < around.neighbor_count; ++i) {
    if (const auto& edge = edges[around.neighbors[i]]) taken_[taken_count_++] = *edge;
  }
  if (taken_count_ == 0) return;
  for (const auto& [a, b] : stars.of(vertex)) {
    if (a >= vertex || b >= vertex || all_faces_ == faces_.size() || !edges[a] || !edges[b]) continue;
    CubeRange range = cubes_at(*edges[a]);
    if (intersect(range, cubes_at(*edges[b]))) faces_[all_faces_++] = range;
  }
  face_count_ = std::min(all_faces_, 3U);
  const CubeRange range = all_faces_ > 0 ? faces_[0] : cubes_at(taken_[0]);
  EdgePlace center{};
  for (center[0] = range.low[0]; center[0] <= range.high[0]; center[0] += 2)
    for (center[1] = range.low[1]; center[1] <= range.high[1]; center[1] += 2)
      for (center[2] = range.low[2]; center[2] <= range.high[2]; center[2] += 2) add_cube(range, center);
}

EdgePlace EdgeCandidates::ranked(unsigned rank) noexcept {
  for (; sorted_ <= rank; ++sorted_) {
    const auto first = scores_.begin() + sorted_;
    std::iter_swap(first, std::min_element(first, scores_.begin() + size_));
  }
  const std::size_t place = places_[static_cast<std::size_t>(scores_[rank] % kNumbers)];
  const EdgePlace& center = cubes_[place / 12];
  const EdgePlace& offset = kCubeEdges[place % 12];
  return {center[0] + offset[0], center[1] + offset[1], center[2] + offset[2]};
}

std::optional<unsigned> EdgeCandidates::rank_of(const EdgePlace& edge, unsigned limit) noexcept {
  for (unsigned rank = 0; rank < std::min(limit, size_); ++rank)
    if (ranked(rank) == edge) return rank;
  return std::nullopt;
}

unsigned EdgeCandidates::doubt() noexcept {
  if (size_ < 2) return 0;
  ranked(1);
  const std::int64_t gap = scores_[1] / kNumbers - scores_[0] / kNumbers;
  const std::int64_t unit = std::max<std::int64_t>(half_ * half_ / 16, 1);
  if (gap >= 8 * unit) return gap >= 32 * unit ? 0 : gap >= 16 * unit ? 1 : 2;
  return gap >= 4 * unit ? 3 : gap >= unit ? 4 : 5;
}

}  // namespace deltamesh
