// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "measure/point_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace deltamesh {

PointTree::PointTree(std::vector<Vec3> points)
    : points_(std::move(points)), order_(points_.size()), axis_(points_.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  std::vector<Range> open{{.first = 0, .end = order_.size()}};
  while (!open.empty()) {
    const Range range = open.back();
    open.pop_back();
    if (range.end - range.first < 2) continue;
    const std::size_t axis = longest_axis(range);
    const std::size_t middle = range.first + (range.end - range.first) / 2;
    const auto begin = order_.begin();
    std::nth_element(
        begin + static_cast<std::ptrdiff_t>(range.first), begin + static_cast<std::ptrdiff_t>(middle),
        begin + static_cast<std::ptrdiff_t>(range.end), [&](std::uint32_t a, std::uint32_t b) {
          return points_[a][axis] != points_[b][axis] ? points_[a][axis] < points_[b][axis] : a < b;
        });
    axis_[middle] = static_cast<std::uint8_t>(axis);
    open.push_back({.first = range.first, .end = middle});
    open.push_back({.first = middle + 1, .end = range.end});
  }
}

std::size_t PointTree::longest_axis(const Range& range) const noexcept {
  Box box = Box::empty();
  for (std::size_t i = range.first; i < range.end; ++i) box.add(points_[order_[i]]);
  return box.longest_axis();
}

void PointTree::nearest(const Vec3& p, std::size_t count, std::vector<NearPoint>& found) const {
  found.clear();
  std::vector<Range> open{{.first = 0, .end = order_.size()}};
  while (!open.empty()) {
    const Range range = open.back();
    open.pop_back();
    if (range.first == range.end) continue;
    if (found.size() == count && range.squared_distance > found.front().squared_distance) continue;
    const std::size_t middle = range.first + (range.end - range.first) / 2;
    const Vec3& point = points_[order_[middle]];
    const Vec3 apart = p - point;
    found.push_back({.squared_distance = dot(apart, apart), .point = order_[middle]});
    std::push_heap(found.begin(), found.end());
    if (found.size() > count) {
      std::pop_heap(found.begin(), found.end());
      found.pop_back();
    }
    const double along = apart[axis_[middle]];
    Range below{.first = range.first, .end = middle, .squared_distance = range.squared_distance};
    Range above{.first = middle + 1, .end = range.end, .squared_distance = range.squared_distance};
    Range& far = along > 0 ? below : above;
    far.squared_distance = std::max(far.squared_distance, along * along);
    // The nearer side is taken from the end of the list first.
    open.push_back(along > 0 ? below : above);
    open.push_back(along > 0 ? above : below);
  }
  std::sort_heap(found.begin(), found.end());
}

}  // namespace deltamesh
