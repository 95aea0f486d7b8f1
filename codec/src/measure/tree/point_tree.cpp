// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "measure/tree/point_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace deltamesh {

PointTree::PointTree(std::vector<Vec3> points) : points_(std::move(points)) {
  if (points_.empty()) return;
  std::vector<std::uint32_t> all(points_.size());
  std::iota(all.begin(), all.end(), 0U);
  boxes_.emplace(points_, all, 1);
}

void PointTree::nearest(const Vec3& p, std::size_t count, std::vector<NearPoint>& found, double most) const {
  found.clear();
  if (!boxes_ || count == 0) return;
  const auto limit = [&] { return found.size() == count ? found.front().squared_distance : most; };
  boxes_->visit_near(
      p, [&](double squared_distance) { return squared_distance > limit(); },
      [&](std::uint32_t point) {
        const Vec3 apart = p - points_[point];
        const NearPoint next{.squared_distance = dot(apart, apart), .point = point};
        if (next.squared_distance > limit()) return;
        found.push_back(next);
        std::push_heap(found.begin(), found.end());
        if (found.size() <= count) return;
        std::pop_heap(found.begin(), found.end());
        found.pop_back();
      });
  std::sort_heap(found.begin(), found.end());
}

}  // namespace deltamesh
