// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How many of the solver's cycles a stream asks its decoders for [DELT-7].
#pragma once

#include <span>

#include "base/vec3.h"
#include "laplacian/solved_part.h"

namespace deltamesh {

/// Half cycles of most streams, tried first; and the most that are tried before it is left to the decoder to
/// decide.
inline constexpr int kUsualHalfCycles = 3;
inline constexpr int kMostPlanned = 13;

/// The fewest half cycles that `will_do(half_cycles)`, which is taken to hold for all larger numbers too; 0
/// where it does for none up to kMostPlanned. The last number that did is the one returned.
template <class WillDo>
int fewest_half_cycles(const WillDo& will_do) {
  int too_few = 0;
  int enough = kUsualHalfCycles;
  for (; !will_do(enough); enough += 2) {
    too_few = enough;
    if (enough >= kMostPlanned) return 0;
  }
  while (enough - 1 > too_few && will_do(enough - 1)) --enough;
  return enough;
}

/// Whether `solution` may stand for `settled`, where the solver decided itself when to stop: how far both are
/// from `positions` hardly differs, rms and at most, nor do their delta coordinates, nor are they far apart.
/// Over the rows of `part`; all spans: one entry for each vertex of the whole graph. `invisible`: model units
/// that nobody would see. O(n).
bool is_as_good(const SolvedPart& part, std::span<const Vec3> positions, std::span<const Vec3> settled,
                std::span<const Vec3> solution, double invisible);

}  // namespace deltamesh
