// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Nearest points of a set: a k-d tree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/numbers/vec3.h"

namespace deltamesh {

/// One answer of a PointTree.
struct NearPoint {
  double squared_distance = 0;
  std::uint32_t point = 0;

  bool operator<(const NearPoint& other) const noexcept {
    if (squared_distance != other.squared_distance) return squared_distance < other.squared_distance;
    return point < other.point;
  }
};

/// Built in O(n log n); a query costs O(log n) where the points are not all equally far.
class PointTree {
 public:
  /// `points`: finite, at most 2^32 - 1.
  explicit PointTree(std::vector<Vec3> points);

  /// The `count` points nearest to `p`, nearest first, ties by index; all where there are fewer. Replaces
  /// the contents of `found`.
  void nearest(const Vec3& p, std::size_t count, std::vector<NearPoint>& found) const;

 private:
  /// Points order_[first, end): the middle one splits them along an axis.
  struct Range {
    std::size_t first = 0;
    std::size_t end = 0;
    double squared_distance = 0;  ///< to the half-space that holds them, at least
  };
  std::size_t longest_axis(const Range& range) const noexcept;

  std::vector<Vec3> points_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint8_t> axis_;  ///< n, of the split at each place of order_
};

}  // namespace deltamesh
