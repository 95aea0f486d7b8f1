// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "predictive/voxel_faces.h"

#include <vector>

namespace deltamesh {

VoxelFaces::VoxelFaces(const FaceList& list, std::span<const std::uint32_t> order)
    : second_walk_((list.vertex_count + 1) / 2) {
  const std::uint32_t none = list.vertex_count;
  stars_.assign(std::size_t{list.vertex_count} + 1, Star{{none, none, none, none}});
  const std::span<const std::uint32_t> corners = list.triangles;
  if (order.empty()) {
    for (std::size_t i = 0; i < corners.size(); i += 3) add({corners[i], corners[i + 1], corners[i + 2]});
    return;
  }
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  for (std::size_t i = 0; i < corners.size(); i += 3)
    add({place[corners[i]], place[corners[i + 1]], place[corners[i + 2]]});
}

[[gnu::always_inline]] inline void VoxelFaces::add(const std::array<std::uint32_t, 3>& corners) noexcept {
  // Which corner is the last one is hard to guess: found without a branch.
  constexpr std::array<std::uint8_t, 4> kLast = {0, 1, 2, 2};
  constexpr std::array<std::uint8_t, 4> kNext = {1, 2, 0, 0};
  constexpr std::array<std::uint8_t, 4> kPrevious = {2, 0, 1, 1};
  const std::array<std::uint32_t, 3> turns = {turn_of(corners[0]), turn_of(corners[1]), turn_of(corners[2])};
  const std::uint32_t last_turn = std::max({turns[0], turns[1], turns[2]});
  const std::size_t which =
      (turns[1] > turns[0] ? 1U : 0U) + (turns[2] > std::max(turns[0], turns[1]) ? 2U : 0U);
  const std::uint32_t a = corners[kNext[which]];
  const std::uint32_t b = corners[kPrevious[which]];
  const unsigned is_none =
      (turn_of(a) == last_turn ? 1U : 0U) | (turn_of(b) == last_turn ? 1U : 0U) | (a == b ? 1U : 0U);
  if (is_none != 0) [[unlikely]]
    return;
  Star& star = stars_[corners[kLast[which]]];
  const bool is_first = star[0] == none();
  star[0] = is_first ? a : star[0];
  star[1] = is_first ? b : star[1];
  star[2] = a;
  star[3] = b;
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
