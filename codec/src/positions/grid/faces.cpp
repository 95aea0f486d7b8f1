// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "positions/grid/faces.h"

namespace deltamesh {
namespace {

/// The corners, numbered by their places in `order`.
std::vector<std::uint32_t> placed_corners(std::span<const std::uint32_t> triangles,
                                          std::span<const std::uint32_t> order) {
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  std::vector<std::uint32_t> placed(triangles.begin(), triangles.end());
  for (std::uint32_t& v : placed) v = place[v];
  return placed;
}

}  // namespace

VoxelFaces::VoxelFaces(const FaceList& list, std::span<const std::uint32_t> order, bool two_sequences)
    : vertex_count_(list.vertex_count),
      second_sequence_(two_sequences ? (list.vertex_count + 1) / 2 : list.vertex_count) {
  if (order.empty()) {
    add_all(list.triangles);
    return;
  }
  add_all(placed_corners(list.triangles, order));
}

void VoxelFaces::add_all(std::span<const std::uint32_t> triangles) {
  with_faces_ = count_with_faces({triangles, vertex_count_});
  stars_.assign(std::size_t{with_faces_} + 1, Star{{none(), none(), none(), none()}});
  const std::uint32_t second_sequence = second_sequence_;
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const std::uint32_t* const corners = triangles.data() + i;
    const RotatedFace face = rotated_face(corners[0], corners[1], corners[2]);
    // Those of one sequence have their steps in the order of their numbers.
    if (face.last >= second_sequence && (face.a < second_sequence || face.b < second_sequence)) [[unlikely]] {
      add_across_sequences({face.last, face.a, face.b});
    } else if (face.is_whole()) {
      add(face);
    }
  }
}

[[gnu::always_inline]] inline void VoxelFaces::add(const RotatedFace& face) noexcept {
  Star& star = stars_[face.last];
  const bool is_first = star[0] == none();
  star[0] = choose(is_first, face.a, star[0]);
  star[1] = choose(is_first, face.b, star[1]);
  star[2] = face.a;
  star[3] = face.b;
}

void VoxelFaces::add_across_sequences(const std::array<std::uint32_t, 3>& corners) noexcept {
  for (std::size_t k = 0; k < 3; ++k) {
    const RotatedFace face{corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]};
    const std::uint32_t step = step_of(face.last);
    if (step_of(face.a) < step && step_of(face.b) < step && face.a != face.b) add(face);
  }
}

Surroundings VoxelFaces::around(std::uint32_t vertex) const noexcept {
  Surroundings around;
  const Star& star = this->star(vertex);
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
