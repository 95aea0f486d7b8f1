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

/// By axis and a set of offsets (bit 0: -1, 1: 0, 2: 1): the edges with one of these offsets on that axis.
constexpr std::array<std::array<std::uint16_t, 8>, 3> kEdgesAt = [] {
  std::array<std::array<std::uint16_t, 8>, 3> sets{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t offsets = 0; offsets < 8; ++offsets)
      for (std::size_t i = 0; i < kCubeEdges.size(); ++i)
        if ((offsets >> (kCubeEdges[i][axis] + 1) & 1) != 0)
          sets[axis][offsets] |= static_cast<std::uint16_t>(1U << i);
  return sets;
}();

/// By 9 x + 3 y + z of the offsets + 1: the edge as a set; none where there is no such edge.
constexpr std::array<std::uint16_t, 27> kEdgeAt = [] {
  std::array<std::uint16_t, 27> sets{};
  for (std::size_t i = 0; i < kCubeEdges.size(); ++i) {
    const auto& [x, y, z] = kCubeEdges[i];
    sets[static_cast<std::size_t>(9 * (x + 1) + 3 * (y + 1) + z + 1)] = static_cast<std::uint16_t>(1U << i);
  }
  return sets;
}();

constexpr std::uint16_t kAllEdges = 0xfff;
constexpr std::int64_t kNumbers = 64;  ///< room for a candidate's number below its score

/// By a set of four: `value` at those that are in it.
using AddedTo4 = std::array<std::array<std::int64_t, 4>, 16>;
constexpr AddedTo4 added(std::int64_t value) noexcept {
  AddedTo4 table{};
  for (std::size_t set = 0; set < table.size(); ++set)
    for (std::size_t i = 0; i < 4; ++i) table[set][i] = (set >> i & 1) != 0 ? value : 0;
  return table;
}

/// How many are in a set of twelve.
constexpr unsigned count12(unsigned set) noexcept {
  set = (set & 0x555) + (set >> 1 & 0x555);
  set = (set & 0x333) + (set >> 2 & 0x333);
  return (set & 0xf) + (set >> 4 & 0xf) + (set >> 8);
}

constexpr std::int64_t kForbidden = std::int64_t{1} << 50;  ///< added for each face that a candidate breaks
constexpr std::int64_t kClosed = std::int64_t{1} << 55;     ///< of edges that are no candidates
constexpr AddedTo4 kForbiddenAt = added(kForbidden);
constexpr AddedTo4 kClosedAt = added(kClosed);
constexpr std::int64_t kFarthest = std::int64_t{1} << 22;  ///< distances per axis are cut here

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
  CubeRange range;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int32_t reach = ~edge[axis] & 1;
    range.low[axis] = edge[axis] - reach;
    range.high[axis] = edge[axis] + reach;
  }
  return range;
}

bool EdgeCandidates::intersect(CubeRange& range, const CubeRange& other) noexcept {
  bool some = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    range.low[axis] = std::max(range.low[axis], other.low[axis]);
    range.high[axis] = std::min(range.high[axis], other.high[axis]);
    some &= range.low[axis] <= range.high[axis];
  }
  return some;
}

EdgeCandidates::EdgeSet EdgeCandidates::shared_edges(const CubeRange& range,
                                                     const EdgePlace& center) noexcept {
  unsigned shared = kAllEdges;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // All are odd: a centre is in the range, next to it, or too far off.
    const std::int32_t below = range.low[axis] - center[axis];
    const std::int32_t above = center[axis] - range.high[axis];
    const unsigned offsets =
        (below <= 0 && above <= 0 ? 7U : 0U) | (below == 2 ? 4U : 0U) | (above == 2 ? 1U : 0U);
    shared &= kEdgesAt[axis][offsets];
  }
  return static_cast<EdgeSet>(shared);
}

EdgeCandidates::EdgeSet EdgeCandidates::edges_taken(const CubeRange& range,
                                                    const EdgePlace& center) const noexcept {
  unsigned taken = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    taken |= kEdgesAt[axis][center[axis] > range.low[axis] ? 1 : 0];
  for (unsigned i = 0; i < taken_count_; ++i) {
    const auto x = static_cast<std::uint32_t>(taken_[i][0] - center[0] + 1);
    const auto y = static_cast<std::uint32_t>(taken_[i][1] - center[1] + 1);
    const auto z = static_cast<std::uint32_t>(taken_[i][2] - center[2] + 1);
    const bool is_near = (x < 3) & (y < 3) & (z < 3);
    taken |= kEdgeAt[is_near ? 9 * x + 3 * y + z : 0];
  }
  return static_cast<EdgeSet>(taken);
}

EdgeCandidates::Squares EdgeCandidates::squares_of(const CubeRange& range) const noexcept {
  Squares squares;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t first = range.low[axis] - std::int64_t{1};
    for (std::size_t i = 0; i < squares[axis].size(); ++i) {
      // Ranges begin at odd places, so that these follow an even one.
      const std::int64_t apart = std::llabs(place_[axis] - half_ * (first + static_cast<std::int64_t>(i)));
      const std::int64_t off = std::clamp<std::int64_t>(apart - (i % 2 != 0 ? half_ : 0), 0, kFarthest);
      squares[axis][i] = off * off;
    }
  }
  return squares;
}

void EdgeCandidates::add_cube(const CubeRange& range, const EdgePlace& center,
                              const Squares& squares) noexcept {
  std::array<const std::int64_t*, 3> at{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    at[axis] = &squares[axis][static_cast<std::size_t>(center[axis] - range.low[axis])];
  std::array<std::int64_t, kCubeEdges.size()> scores;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t* next = at[(axis + 1) % 3];
    const std::int64_t* last = at[(axis + 2) % 3];
    for (std::size_t corner = 0; corner < 4; ++corner)
      scores[4 * axis + corner] = at[axis][1] + next[2 * (corner % 2)] + last[2 * (corner / 2)];
  }
  const auto add = [&scores](const AddedTo4& table, unsigned set) {
    for (std::size_t four = 0; four < 3; ++four)
      for (std::size_t i = 0; i < 4; ++i) scores[4 * four + i] += table[set >> (4 * four) & 15][i];
  };
  const unsigned open = kAllEdges & ~edges_taken(range, center);
  add(kClosedAt, kAllEdges & ~open);
  unsigned allowed = open;
  for (unsigned f = 1; f < all_faces_; ++f) {  // the first has them all
    const unsigned shared = shared_edges(faces_[f], center);
    allowed &= shared;
    add(kForbiddenAt, kAllEdges & ~shared);
  }
  likely_ += count12(allowed);
  size_ += count12(open);
  const std::size_t first = kCubeEdges.size() * cube_count_;
  cubes_[cube_count_++] = center;
  for (std::size_t i = 0; i < kCubeEdges.size(); ++i) {
    const std::int64_t score = scores[i] * kNumbers + static_cast<std::int64_t>(first + i);
    scores_[first + i] = score;
    second_ = std::min(second_, std::max(best_, score));
    best_ = std::min(best_, score);
  }
}

EdgeCandidates::EdgeCandidates(const Surroundings& around, std::span<const std::optional<EdgePlace>> edges,
                               const std::array<std::int64_t, 3>& place, const VoxelGrid& grid) noexcept
    : place_(place), half_(std::int64_t{8} * grid.voxel()) {
  for (unsigned i = 0; i < around.known_count; ++i) {
    if (const auto& edge = edges[around.known[i].a]) taken_[taken_count_++] = *edge;
    if (const auto& edge = edges[around.known[i].b]) taken_[taken_count_++] = *edge;
  }
  if (taken_count_ == 0) return;
  for (unsigned i = 0; i < around.known_count; ++i) {
    const std::uint32_t a = around.known[i].a;
    const std::uint32_t b = around.known[i].b;
    if (!edges[a] || !edges[b]) continue;
    CubeRange range = cubes_at(*edges[a]);
    if (intersect(range, cubes_at(*edges[b]))) faces_[all_faces_++] = range;
  }
  face_count_ = std::min(all_faces_, 3U);
  const CubeRange range = all_faces_ > 0 ? faces_[0] : cubes_at(taken_[0]);
  const Squares squares = squares_of(range);
  EdgePlace center{};
  for (center[0] = range.low[0]; center[0] <= range.high[0]; center[0] += 2)
    for (center[1] = range.low[1]; center[1] <= range.high[1]; center[1] += 2)
      for (center[2] = range.low[2]; center[2] <= range.high[2]; center[2] += 2)
        add_cube(range, center, squares);
}

EdgePlace EdgeCandidates::ranked(unsigned rank) const noexcept {
  std::int64_t score = rank == 0 ? best_ : second_;
  for (; rank > 1; --rank) {
    std::int64_t next = kNone;
    for (std::size_t i = 0; i < kCubeEdges.size() * cube_count_; ++i)
      next = std::min(next, scores_[i] > score ? scores_[i] : kNone);
    score = next;
  }
  const auto number = static_cast<std::size_t>(score % kNumbers);
  const EdgePlace& center = cubes_[number / kCubeEdges.size()];
  const EdgePlace& offset = kCubeEdges[number % kCubeEdges.size()];
  return {center[0] + offset[0], center[1] + offset[1], center[2] + offset[2]};
}

std::optional<unsigned> EdgeCandidates::rank_of(const EdgePlace& edge, unsigned limit) const noexcept {
  for (unsigned rank = 0; rank < std::min(limit, size_); ++rank)
    if (ranked(rank) == edge) return rank;
  return std::nullopt;
}

unsigned EdgeCandidates::doubt() const noexcept {
  if (size_ < 2) return 0;
  const std::int64_t gap = second_ / kNumbers - best_ / kNumbers;
  const std::int64_t unit = std::max<std::int64_t>(half_ * half_ / 16, 1);
  unsigned doubt = 5;
  for (const std::int64_t units : {1, 4, 8, 16, 32}) doubt -= gap >= units * unit ? 1 : 0;
  return doubt;
}

}  // namespace deltamesh
