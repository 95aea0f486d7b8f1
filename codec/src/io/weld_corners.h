// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Merges equal points of an unindexed triangle list.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace deltamesh {

struct WeldedCorners {
  std::vector<double> coordinates;     ///< n x 3, in the order in which the points are first met
  std::vector<std::uint32_t> corners;  ///< the point of every corner
};

/// `coordinates`: 3 per corner, fewer than 2^32 corners. Points are equal where their bits are, except that
/// -0 equals 0. Cost O(n log n), whatever the points.
WeldedCorners weld_corners(std::span<const double> coordinates);

}  // namespace deltamesh
