// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From OBJ's corners, which index positions, texture coordinates and normals apart, to one index per corner.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

namespace deltamesh {

/// Indices from 0; kNone: not given.
struct ObjCorner {
  static constexpr std::int64_t kNone = -1;
  std::int64_t position = kNone;
  std::int64_t uv = kNone;
  std::int64_t normal = kNone;
  auto operator<=>(const ObjCorner&) const = default;
};

struct ObjVertices {
  std::vector<ObjCorner> vertices;     ///< what each vertex is made of
  std::vector<std::uint32_t> corners;  ///< the vertex of every corner
};

/// One vertex per distinct corner. The first combination met of a position takes the position's own index, so
/// vertices keep the order of the file's positions (those no corner uses included); further combinations
/// follow in the order in which they are met. Cost O(n log n).
ObjVertices split_obj_corners(std::span<const ObjCorner> corners, std::size_t positions);

}  // namespace deltamesh
