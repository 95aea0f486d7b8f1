// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Predicts a vertex with one or two known faces, as most have: the same result as expect_place(), computed at
// once [POSN-4].
#pragma once

#include <span>

#include "base/simd/four_ints.h"
#include "positions/blend/blend.h"
#include "positions/surroundings.h"

namespace deltamesh {

/// False, and nothing said, where corners are far apart.
[[gnu::always_inline]] inline bool expect_pair(const FacePair& pair, std::span<const Cell> cells,
                                               const BlendTable& table, Expectation& result) noexcept {
  const KnownFace& first = pair.first;
  const KnownFace& second = pair.second;
  // From the first one's corner a.
  const FourInts base = four_ints(cells[first.a]);
  const FourInts first_sum = four_ints(cells[first.b]) - base;
  const FourInts first_opposite = four_ints(cells[first.opposite]) - base;
  const FourInts second_a = four_ints(cells[second.a]) - base;
  const FourInts second_b = four_ints(cells[second.b]) - base;
  const FourInts second_opposite = four_ints(cells[second.opposite]) - base;
  const FourInts beyond = (first_sum + kNear) | (first_opposite + kNear) | (second_a + kNear) |
                          (second_b + kNear) | (second_opposite + kNear);
  if (set_lanes((beyond & ~(2 * kNear - 1)) != 0) != 0) [[unlikely]]
    return false;

  const FourInts second_sum = second_a + second_b;
  const FourInts sum = first_sum + second_sum;
  const FourInts first_corner = first_sum - first_opposite;
  const FourInts second_corner = second_sum - second_opposite;
  // Corners that the faces share count once; the first face's a is 0.
  const bool shares_first_a = first.a == second.b;
  const bool shares_second_a = second.a == first.b;
  const FourInts shared = second_a & (FourInts{} - (shares_second_a ? 1 : 0));
  const FourInts neighbors =
      mean_lanes((sum - shared) << 4, 4U - (shares_first_a ? 1U : 0U) - (shares_second_a ? 1U : 0U));
  const FourInts parallelograms = (first_corner + second_corner) << 3;
  const FourInts edges = sum << 2;
  const Blend& blend = table[blend_row(pair.known_count, pair.faces)];
  result.whole = base;
  result.offset =
      neighbors +
      (((parallelograms - neighbors) * blend.parallelogram + (edges - neighbors) * blend.edge) >> 6);
  result.spread = lane_sizes(first_corner - second_corner) << 3;
  return true;
}

}  // namespace deltamesh
