// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Nearest points of a set: boxes of points in a tree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "base/numbers/vec3.h"
#include "measure/tree/box_tree.h"

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
  /// `points`: finite, at most 2^31 - 1.
  explicit PointTree(std::vector<Vec3> points);

  /// The `count` points nearest to `p`, nearest first, ties by index; all where there are fewer; none whose
  /// squared distance is above `most`. Replaces the contents of `found`.
  void nearest(const Vec3& p, std::size_t count, std::vector<NearPoint>& found,
               double most = std::numeric_limits<double>::infinity()) const;

 private:
  std::vector<Vec3> points_;
  std::optional<BoxTree> boxes_;  ///< empty where there are no points
};

}  // namespace deltamesh
