// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/obj_corners.h"

#include <algorithm>
#include <numeric>

namespace deltamesh {

ObjVertices split_obj_corners(std::span<const ObjCorner> corners, std::size_t positions) {
  // Equal corners side by side, the first met of them first.
  std::vector<std::uint32_t> order(corners.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto compared = corners[a] <=> corners[b];
    return compared != 0 ? compared < 0 : a < b;
  });
  std::vector<std::uint32_t> first(corners.size());  // the first corner that equals this one
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool again = i > 0 && corners[order[i]] == corners[order[i - 1]];
    first[order[i]] = again ? first[order[i - 1]] : order[i];
  }

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
