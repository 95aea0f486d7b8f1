// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "connectivity/seams/corner_copies.h"

#include <cstddef>

namespace deltamesh {

SplitVertices split_vertices(std::span<const std::uint32_t> geometric_triangles, const CornerCopies& copies) {
  SplitVertices split;
  std::vector<std::uint32_t> first(copies.of_vertex.size());
  std::uint32_t count = 0;
  for (std::uint32_t g = 0; g < first.size(); ++g) {
    first[g] = count;
    count += copies.of_vertex[g];
  }
  split.geometric.resize(count);
  for (std::uint32_t g = 0; g < first.size(); ++g)
    for (std::uint32_t k = 0; k < copies.of_vertex[g]; ++k) split.geometric[first[g] + k] = g;
  split.triangles.resize(geometric_triangles.size());
  for (std::size_t c = 0; c < split.triangles.size(); ++c)
    split.triangles[c] = first[geometric_triangles[c]] + copies.of_corner[c];
  return split;
}

}  // namespace deltamesh
