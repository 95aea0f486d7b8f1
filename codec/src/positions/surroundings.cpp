// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "positions/surroundings.h"

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

KnownFaces::KnownFaces(const FaceList& list)
    : stars_(count_with_faces(list), Star{}), vertex_count_(list.vertex_count) {
  Star* const stars = stars_.data();
  for (std::size_t i = 0; i < list.triangles.size(); i += 3) {
    const std::uint32_t* const corners = list.triangles.data() + i;
    for (std::size_t k = 0; k < 3; ++k) ++stars[corners[k]].faces;
    const RotatedFace face = rotated_face(corners[0], corners[1], corners[2]);
    if (face.is_whole()) stars[face.last].add(face.a, face.b);
  }
}

}  // namespace deltamesh
