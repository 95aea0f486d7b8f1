// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "measure/tree/box_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace deltamesh {
namespace {

constexpr std::size_t kLeafItems = 4;
constexpr std::uint32_t kNoParent = std::numeric_limits<std::uint32_t>::max();

}  // namespace

BoxTree::BoxTree(std::span<const Vec3> positions, std::span<const std::uint32_t> corners,
                 std::size_t corners_per_item)
    : order_(corners.size() / corners_per_item) {
  std::iota(order_.begin(), order_.end(), 0U);
  const auto corners_of = [&](std::uint32_t item) {
    return corners.subspan(corners_per_item * item, corners_per_item);
  };
  const auto box_of = [&](std::size_t begin, std::size_t end) {
    Box box = Box::empty();
    for (std::size_t i = begin; i < end; ++i)
      for (const std::uint32_t corner : corners_of(order_[i])) box.add(positions[corner]);
    return box;
  };
  struct Range {
    std::size_t begin, end;
    std::uint32_t parent;  ///< whose right child this is, or kNoParent
  };
  std::vector<Range> pending{{0, order_.size(), kNoParent}};
  while (!pending.empty()) {
    const Range range = pending.back();
    pending.pop_back();
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    if (range.parent != kNoParent) nodes_[range.parent].first = index;
    const std::size_t count = range.end - range.begin;
    nodes_.push_back({box_of(range.begin, range.end), 0, 0});
    if (count <= kLeafItems) {
      nodes_.back().first = static_cast<std::uint32_t>(range.begin);
      nodes_.back().count = static_cast<std::uint32_t>(count);
      continue;
    }
    const std::size_t axis = nodes_.back().box.longest_axis();
    const std::size_t middle = range.begin + count / 2;
    const auto centre = [&](std::uint32_t item) {
      double sum = 0;
      for (const std::uint32_t corner : corners_of(item)) sum += positions[corner][axis];
      return sum;
    };
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(range.begin), at(middle), at(range.end), [&](std::uint32_t s, std::uint32_t t) {
      const double cs = centre(s);
      const double ct = centre(t);
      return cs < ct || (cs == ct && s < t);
    });
    pending.push_back({middle, range.end, index});
    pending.push_back({range.begin, middle, kNoParent});
  }
}

double BoxTree::squared_distance(const Box& box, const Vec3& p) noexcept {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double outside = std::max({box.min[k] - p[k], 0.0, p[k] - box.max[k]});
    sum += outside * outside;
  }
  return sum;
}

}  // namespace deltamesh
