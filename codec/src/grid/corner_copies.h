// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Bricks that know the corners of a cube: its own, and those that have one in their margin.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "grid/brick.h"

namespace deltamesh::grid {

/// A brick that knows the corners of a cube, and where they are there.
struct CornerCopy {
  std::uint8_t near;  ///< which one, seen from the cube's own brick
  std::int8_t shift;  ///< to the bit of the lowest corner, added to its x
  std::int16_t row;   ///< added to the row of the lowest corner
};
struct CornerCopies {
  unsigned count;
  std::array<CornerCopy, 8> list;
};

/// Of a cube's coordinates: 1 if its corners are in the margin of the brick on the low side, 2 on the high
/// side.
inline constexpr std::array<std::uint8_t, kSide> kBrickEnds = {1, 1, 0, 0, 0, 0, 0, 0,
                                                               0, 0, 0, 0, 0, 2, 2, 2};

/// By the ends on each axis.
inline constexpr std::array<CornerCopies, 27> kCornerCopies = [] {
  std::array<CornerCopies, 27> all{};
  for (int ends = 0; ends < 27; ++ends) {
    CornerCopies& copies = all[static_cast<std::size_t>(ends)];
    const int end[3] = {ends % 3, ends / 3 % 3, ends / 9};
    for (int way = 0; way < 27; ++way) {
      const int step[3] = {way % 3 - 1, way / 3 % 3 - 1, way / 9 - 1};
      bool has_them = true;
      for (int axis = 0; axis < 3; ++axis)
        has_them = has_them && (step[axis] == 0 || end[axis] == (step[axis] < 0 ? 1 : 2));
      if (!has_them) continue;
      copies.list[copies.count++] = {static_cast<std::uint8_t>(way),
                                     static_cast<std::int8_t>(kMargin - kSide * step[0]),
                                     static_cast<std::int16_t>(-kSide * (step[1] + kReach * step[2]))};
    }
  }
  return all;
}();

inline const CornerCopies& copies_of(unsigned place) noexcept {
  return kCornerCopies[kBrickEnds[place & 15] + 3U * kBrickEnds[place >> 4 & 15] +
                       9U * kBrickEnds[place >> 8]];
}

}  // namespace deltamesh::grid
