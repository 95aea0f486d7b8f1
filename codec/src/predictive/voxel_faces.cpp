// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "predictive/voxel_faces.h"

#include <vector>

namespace deltamesh {

VoxelFaces::VoxelFaces(const FaceList& list, std::span<const std::uint32_t> order)
    : vertex_count_(list.vertex_count), second_walk_((list.vertex_count + 1) / 2) {
  stars_.assign(std::size_t{list.vertex_count} + 1, Star{{none(), none(), none(), none()}});
  const std::span<const std::uint32_t> corners = list.triangles;
  if (order.empty()) {
    for (std::size_t i = 0; i < corners.size(); i += 3) add(corners.data() + i);
    return;
  }
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    const std::array<std::uint32_t, 3> placed = {place[corners[i]], place[corners[i + 1]],
                                                 place[corners[i + 2]]};
    add(placed.data());
  }
}

/// Three of them.
[[gnu::always_inline]] inline void VoxelFaces::add(const std::uint32_t* corners) noexcept {
  // Which corner is the last one, and whether the face is its first, is hard to guess: all without branches.
  static constexpr std::array<std::uint8_t, 4> kLast = {0, 1, 2, 2};
  static constexpr std::array<std::uint8_t, 4> kNext = {1, 2, 0, 0};
  static constexpr std::array<std::uint8_t, 4> kPrevious = {2, 0, 1, 1};
  const std::uint32_t turn = turn_of(corners[0]);
  const std::uint32_t of_two = std::max(turn, turn_of(corners[1]));
  const std::uint32_t of_all = std::max(of_two, turn_of(corners[2]));
  const std::size_t which = (of_two != turn ? 1U : 0U) + (of_all != of_two ? 2U : 0U);
  const std::uint32_t a = corners[kNext[which]];
  const std::uint32_t b = corners[kPrevious[which]];
  if (a == b || turn_of(a) == of_all || turn_of(b) == of_all) [[unlikely]]
    return;
  Star& star = stars_[corners[kLast[which]]];
  const FourInts now = four_ints(star);
  const FourInts face = four_ints(std::array<std::uint32_t, 4>{a, b, a, b});
  const FourInts is_new = (now == static_cast<std::int32_t>(none())) | FourInts{0, 0, -1, -1};
  star = std::bit_cast<Star>((face & is_new) | (now & ~is_new));
}

Surroundings VoxelFaces::around(std::uint32_t vertex) const noexcept {
  Surroundings around;
  const Star& star = stars_[vertex];
  if (star[0] == none()) return around;
  const bool is_one = star[0] == star[2] && star[1] == star[3];
  around.known_count = is_one ? 1 : 2;
  around.faces = around.known_count;
  for (std::size_t i = 0; i < around.known_count; ++i) {
    KnownFace& face = around.known[i];
    face = {star[2 * i], star[2 * i + 1], across(star[2 * i], star[2 * i + 1])};
    if (face.opposite == none()) face.opposite = kNoVertex;
    around.parallelogram_count += face.opposite != kNoVertex ? 1 : 0;
  }
  if (!is_one) around.repeated = FourInts{star[0] == star[3] ? -1 : 0, star[2] == star[1] ? -1 : 0, 0, 0};
  around.neighbor_count =
      2 * around.known_count - static_cast<unsigned>(std::popcount(set_lanes(around.repeated)));
  return around;
}

}  // namespace deltamesh
