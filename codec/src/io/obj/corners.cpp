// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/obj/corners.h"

#include "io/first_equal.h"

namespace deltamesh {

ObjVertices split_obj_corners(std::span<const ObjCorner> corners, std::size_t positions) {
  const std::vector<std::uint32_t> first =
      first_equal(corners.size(), [&](std::uint32_t c) -> const ObjCorner& { return corners[c]; });
  ObjVertices result;
  result.vertices.resize(positions);
  for (std::size_t v = 0; v < positions; ++v) result.vertices[v].position = static_cast<std::int64_t>(v);
  result.corners.resize(corners.size());
  std::vector<bool> taken(positions);
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const auto own = static_cast<std::size_t>(corners[c].position);
    if (first[c] != c) {
      result.corners[c] = result.corners[first[c]];
    } else if (!taken[own]) {
      taken[own] = true;
      result.vertices[own] = corners[c];
      result.corners[c] = static_cast<std::uint32_t>(own);
    } else {
      result.corners[c] = static_cast<std::uint32_t>(result.vertices.size());
      result.vertices.push_back(corners[c]);
    }
  }
  return result;
}

}  // namespace deltamesh
