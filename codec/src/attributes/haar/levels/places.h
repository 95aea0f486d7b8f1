// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Positions as whole numbers, equal on every machine [HAAR-2].
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/memory/large_vector.h"
#include "base/simd/four_ints.h"

namespace deltamesh {

inline constexpr unsigned kHaarPlaceBits = 20;

/// Each coordinate from 0 to 2^20 - 1.
using HaarPlace = std::array<std::int32_t, 3>;

/// n places. `positions`: n x 3 floats of any value, or empty: then all places are 0. O(n).
LargeVector<HaarPlace> make_haar_places(std::span<const float> positions, std::uint32_t vertex_count);

/// The squared distance of two places, whose differences the first three lanes are. A whole number below
/// 2^42, which doubles compute exactly.
inline double squared_distance(FourInts difference) noexcept {
  const TwoDoubles xy = low_doubles(difference);
  const TwoDoubles squares = xy * xy;
  const double z = low_doubles(pick_lanes<2, 3, 2, 3>(difference))[0];
  return squares[0] + squares[1] + z * z;
}

}  // namespace deltamesh
