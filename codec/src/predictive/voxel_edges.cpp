// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "predictive/voxel_edges.h"

#include <algorithm>
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

bool EdgeCandidates::allowed(const CubeRange& range, const EdgePlace& edge) const noexcept {
  bool inside = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
    inside = inside && edge[axis] >= range.low[axis] - 1 && edge[axis] <= range.high[axis] + 1;
  return inside;
}

std::int64_t EdgeCandidates::distance(const EdgePlace& edge) const noexcept {
  std::int64_t sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::int64_t off = std::llabs(place_[axis] - half_ * edge[axis]);
    if ((edge[axis] & 1) != 0) off = std::max<std::int64_t>(off - half_, 0);
    off = std::min(off, kFarthest);
    sum += off * off;
  }
  return sum;
}

void EdgeCandidates::add_cube(const CubeRange& range, const EdgePlace& center) noexcept {
  for (const EdgePlace& offset : kCubeEdges) {
    const EdgePlace edge = {center[0] + offset[0], center[1] + offset[1], center[2] + offset[2]};
    // An edge that an earlier cube of the range has too is there already.
    bool met = false;
    for (std::size_t axis = 0; axis < 3; ++axis)
      met = met || (offset[axis] == -1 && center[axis] > range.low[axis]);
    if (met) continue;
    const auto taken_end = taken_.begin() + taken_count_;
    if (std::find(taken_.begin(), taken_end, edge) != taken_end) continue;
    std::int64_t score = distance(edge);
    unsigned broken = 0;
    for (unsigned f = 0; f < all_faces_; ++f) broken += allowed(faces_[f], edge) ? 0 : 1;
    likely_ += broken == 0 ? 1 : 0;
    score += kForbidden * broken;
    if (size_ < kMost) candidates_[size_++] = {edge, score};
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

const EdgePlace& EdgeCandidates::ranked(unsigned rank) noexcept {
  for (; sorted_ <= rank; ++sorted_) {
    unsigned best = sorted_;
    for (unsigned i = sorted_ + 1; i < size_; ++i)
      if (candidates_[i].score < candidates_[best].score) best = i;
    // The others keep their order, so that ties are the same everywhere.
    std::rotate(candidates_.begin() + sorted_, candidates_.begin() + best, candidates_.begin() + best + 1);
  }
  return candidates_[rank].edge;
}

std::optional<unsigned> EdgeCandidates::rank_of(const EdgePlace& edge, unsigned limit) noexcept {
  for (unsigned rank = 0; rank < std::min(limit, size_); ++rank)
    if (ranked(rank) == edge) return rank;
  return std::nullopt;
}

unsigned EdgeCandidates::doubt() noexcept {
  if (size_ < 2) return 0;
  ranked(1);
  const std::int64_t best = candidates_[0].score;
  const std::int64_t next = candidates_[1].score;
  // Beyond the score's own scale: the width of a voxel, squared.
  const std::int64_t gap = (next - best) / std::max<std::int64_t>(half_ * half_ / 16, 1);
  return gap >= 32 ? 0 : gap >= 16 ? 1 : gap >= 8 ? 2 : gap >= 4 ? 3 : gap >= 1 ? 4 : 5;
}

}  // namespace deltamesh
