// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Ranges are halved at the median of the longest side, so the depth is at most 32 whatever the input, and an
// array serves as the stack of a query.
#include "measure/triangle_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace deltamesh {
namespace {

constexpr std::size_t kLeafTriangles = 4;
constexpr std::size_t kMaxDepth = 40;
constexpr std::uint32_t kNoParent = std::numeric_limits<std::uint32_t>::max();

/// Nearest point of the segment from corner i to corner j, as weights of the corners.
Vec3 nearest_on_edge(const Vec3& p, const std::array<Vec3, 3>& corners, std::size_t i,
                     std::size_t j) noexcept {
  const Vec3 along = corners[j] - corners[i];
  const double squared = dot(along, along);
  const double t = squared > 0 ? std::clamp(dot(p - corners[i], along) / squared, 0.0, 1.0) : 0.0;
  Vec3 weights{};
  weights[i] = 1 - t;
  weights[j] = t;
  return weights;
}

SurfacePoint at_weights(const Vec3& p, const std::array<Vec3, 3>& corners, const Vec3& weights) noexcept {
  SurfacePoint point;
  point.weights = weights;
  point.position = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
  const Vec3 apart = p - point.position;
  point.squared_distance = dot(apart, apart);
  return point;
}

double squared_distance(const Box& box, const Vec3& p) noexcept {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double outside = std::max({box.min[k] - p[k], 0.0, p[k] - box.max[k]});
    sum += outside * outside;
  }
  return sum;
}

}  // namespace

SurfacePoint nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) noexcept {
  const std::array<Vec3, 3> corners{a, b, c};
  const Vec3 normal = cross(b - a, c - a);
  const double squared = dot(normal, normal);
  if (squared > 0) {
    // Signed areas of the sub-triangles over the whole: the weights of the foot of the perpendicular.
    const double weight_b = dot(cross(p - a, c - a), normal) / squared;
    const double weight_c = dot(cross(b - a, p - a), normal) / squared;
    const double weight_a = 1 - weight_b - weight_c;
    if (weight_a >= 0 && weight_b >= 0 && weight_c >= 0)
      return at_weights(p, corners, {weight_a, weight_b, weight_c});
  }
  SurfacePoint best = at_weights(p, corners, nearest_on_edge(p, corners, 0, 1));
  for (const std::size_t i : {std::size_t{1}, std::size_t{2}}) {
    const SurfacePoint other = at_weights(p, corners, nearest_on_edge(p, corners, i, (i + 1) % 3));
    if (other.squared_distance < best.squared_distance) best = other;
  }
  return best;
}

TriangleTree::TriangleTree(std::span<const Vec3> positions, std::span<const std::uint32_t> triangles)
    : positions_(positions), triangles_(triangles), order_(triangles.size() / 3) {
  std::iota(order_.begin(), order_.end(), 0U);
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
    nodes_.push_back({box_of({order_.data() + range.begin, count}), 0, 0});
    if (count <= kLeafTriangles) {
      nodes_.back().first = static_cast<std::uint32_t>(range.begin);
      nodes_.back().count = static_cast<std::uint32_t>(count);
      continue;
    }
    const std::size_t axis = nodes_.back().box.longest_axis();
    const std::size_t middle = range.begin + count / 2;
    const auto centre = [&](std::uint32_t t) {
      return positions_[triangles_[3 * std::size_t{t}]][axis] +
             positions_[triangles_[3 * std::size_t{t} + 1]][axis] +
             positions_[triangles_[3 * std::size_t{t} + 2]][axis];
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

Box TriangleTree::box_of(std::span<const std::uint32_t> members) const noexcept {
  Box box = Box::empty();
  for (const std::uint32_t t : members)
    for (std::size_t corner = 0; corner < 3; ++corner)
      box.add(positions_[triangles_[3 * std::size_t{t} + corner]]);
  return box;
}

SurfacePoint TriangleTree::nearest_on(std::uint32_t triangle, const Vec3& p) const noexcept {
  const std::size_t first = 3 * std::size_t{triangle};
  SurfacePoint point = nearest_on_triangle(
      p, positions_[triangles_[first]], positions_[triangles_[first + 1]], positions_[triangles_[first + 2]]);
  point.triangle = triangle;
  return point;
}

SurfacePoint TriangleTree::nearest(const Vec3& p, std::uint32_t hint) const noexcept {
  SurfacePoint best = nearest_on(hint, p);
  struct Waiting {
    std::uint32_t node;
    double squared_distance;
  };
  // At most one node waits per level; see the top of this file.
  std::array<Waiting, kMaxDepth> stack;
  std::size_t waiting = 0;
  stack[waiting++] = {0, squared_distance(nodes_[0].box, p)};
  while (waiting > 0) {
    const Waiting top = stack[--waiting];
    if (top.squared_distance >= best.squared_distance) continue;
    const Node& node = nodes_[top.node];
    for (std::uint32_t i = 0; i < node.count; ++i)
      if (const SurfacePoint point = nearest_on(order_[node.first + i], p);
          point.squared_distance < best.squared_distance)
        best = point;
    if (node.count > 0) continue;
    Waiting near{top.node + 1, squared_distance(nodes_[top.node + 1].box, p)};
    Waiting far{node.first, squared_distance(nodes_[node.first].box, p)};
    if (far.squared_distance < near.squared_distance) std::swap(near, far);
    stack[waiting++] = far;
    stack[waiting++] = near;
  }
  return best;
}

}  // namespace deltamesh
