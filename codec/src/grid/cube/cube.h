// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A cube of the grid: the numbers of its corners, edges and faces [GRD-1].
//
//        6-------7        corner i is at (i & 1, i >> 1 & 1, i >> 2) from the lowest one, 0
//       /|      /|
//      4-------5 |        edge 4 k + i has axis k and begins i & 1 from corner 0 on the axis after k,
//      | 2-----|-3        and i >> 1 on the one after that
//      |/      |/
//      0-------1          face 2 k + d is across axis k, on the low (d = 0) or the high side
#pragma once

#include <array>
#include <cstdint>

namespace deltamesh::grid {

/// Coordinates of a node of the grid, or of the cube whose lowest corner it is.
using Node = std::array<std::int32_t, 3>;

inline constexpr unsigned kCorners = 8;
inline constexpr unsigned kEdges = 12;
inline constexpr unsigned kFaces = 6;
inline constexpr unsigned kInside = kEdges;  ///< stands for a vertex inside the cube, among edges

/// A bit for every corner, set where it is outside.
using Signs = unsigned;

/// Corner at which an edge begins; it ends at the one 1 << axis after it.
inline constexpr std::array<std::uint8_t, kEdges> kFirstCorners = [] {
  std::array<std::uint8_t, kEdges> corners{};
  for (unsigned edge = 0; edge < kEdges; ++edge) {
    const unsigned k = edge / 4;
    corners[edge] = static_cast<std::uint8_t>((edge & 1) << (k + 1) % 3 | (edge >> 1 & 1) << (k + 2) % 3);
  }
  return corners;
}();
constexpr unsigned first_corner(unsigned edge) noexcept { return kFirstCorners[edge]; }
constexpr unsigned last_corner(unsigned edge) noexcept { return first_corner(edge) | 1U << edge / 4; }

/// The edge between two corners that differ in one bit.
constexpr unsigned edge_between(unsigned a, unsigned b) noexcept {
  const unsigned axis = (a ^ b) / 2;  // 1, 2, 4
  const unsigned low = a & b;
  return 4 * axis + (low >> (axis + 1) % 3 & 1) + 2 * (low >> (axis + 2) % 3 & 1);
}

/// Corners of each face, seen from outside the cube one after the other.
inline constexpr std::array<std::array<std::uint8_t, 4>, kFaces> kFaceCorners = [] {
  std::array<std::array<std::uint8_t, 4>, kFaces> corners{};
  for (unsigned k = 0; k < 3; ++k) {
    const unsigned next = 1U << (k + 1) % 3;
    const unsigned last = 1U << (k + 2) % 3;
    for (unsigned d = 0; d < 2; ++d) {
      const unsigned base = d << k;
      corners[2 * k + d] = {static_cast<std::uint8_t>(base),
                            static_cast<std::uint8_t>(base | (d != 0 ? next : last)),
                            static_cast<std::uint8_t>(base | next | last),
                            static_cast<std::uint8_t>(base | (d != 0 ? last : next))};
    }
  }
  return corners;
}();

/// By signs: a bit for every face whose corners are not all on one side.
inline constexpr std::array<std::uint8_t, 256> kCrossedFaces = [] {
  std::array<std::uint8_t, 256> crossed{};
  for (Signs signs = 0; signs < 256; ++signs) {
    for (unsigned f = 0; f < kFaces; ++f) {
      unsigned outside = 0;
      for (const unsigned corner : kFaceCorners[f]) outside += signs >> corner & 1;
      if (outside % 4 != 0) crossed[signs] = static_cast<std::uint8_t>(crossed[signs] | 1U << f);
    }
  }
  return crossed;
}();

}  // namespace deltamesh::grid
