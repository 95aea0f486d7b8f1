// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "predictive/surroundings.h"

#include <algorithm>

#include "predictive/turned_face.h"

namespace deltamesh {

std::uint32_t count_with_faces(const FaceList& list) noexcept {
  // From the end, where the last vertex mostly is.
  constexpr std::size_t kAtOnce = 1536;
  std::uint32_t count = 0;
  for (std::size_t end = list.triangles.size(); end > 0 && count < list.vertex_count;) {
    const std::size_t begin = end - std::min(end, kAtOnce);
    std::uint32_t last = 0;
    for (std::size_t i = begin; i < end; ++i) last = std::max(last, list.triangles[i]);
    count = std::max(count, last + 1);
    end = begin;
  }
  return count;
}

KnownFaces::KnownFaces(const FaceList& list, std::span<const std::uint32_t> order)
    : vertex_count_(list.vertex_count) {
  if (order.empty()) {
    add_all(list.triangles);
    return;
  }
  add_all(placed_corners(list.triangles, order));
}

void KnownFaces::add_all(std::span<const std::uint32_t> triangles) {
  stars_.assign(count_with_faces({triangles, vertex_count_}), Star{});
  Star* const stars = stars_.data();
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const std::uint32_t* const corners = triangles.data() + i;
    for (std::size_t k = 0; k < 3; ++k) ++stars[corners[k]].faces;
    const TurnedFace face = turned_face(corners[0], corners[1], corners[2]);
    if (face.is_whole()) stars[face.last].add(face.a, face.b);
  }
}

std::vector<std::uint32_t> placed_corners(std::span<const std::uint32_t> triangles,
                                          std::span<const std::uint32_t> order) {
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  std::vector<std::uint32_t> placed(triangles.begin(), triangles.end());
  for (std::uint32_t& v : placed) v = place[v];
  return placed;
}

}  // namespace deltamesh
