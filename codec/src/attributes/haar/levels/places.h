// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Positions as whole numbers, equal on every machine [HAAR-2].
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/memory/large_vector.h"

namespace deltamesh {

inline constexpr unsigned kHaarPlaceBits = 20;

/// Each coordinate from 0 to 2^20 - 1.
using HaarPlace = std::array<std::int32_t, 3>;

/// n places. `positions`: n x 3 floats of any value, or empty: then all places are 0. O(n).
LargeVector<HaarPlace> make_haar_places(std::span<const float> positions, std::uint32_t vertex_count);

inline std::uint64_t squared_distance(const HaarPlace& a, const HaarPlace& b) noexcept {
  std::uint64_t sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t way = std::int64_t{a[axis]} - b[axis];
    sum += static_cast<std::uint64_t>(way * way);
  }
  return sum;
}

}  // namespace deltamesh
