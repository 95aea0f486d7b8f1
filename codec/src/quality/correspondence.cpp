// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "quality/correspondence.h"

#include <algorithm>
#include <array>
#include <vector>

namespace deltamesh {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// The smallest of the three rotations; equal for two triangles exactly when one is a rotation of the other.
Triangle canonical(const Triangle& t) {
  return std::min({t, Triangle{t[1], t[2], t[0]}, Triangle{t[2], t[0], t[1]}});
}

template <class Map>
std::vector<Triangle> sorted_triangles(std::span<const std::uint32_t> triangles, Map map) {
  std::vector<Triangle> sorted(triangles.size() / 3);
  for (std::size_t i = 0; i < sorted.size(); ++i)
    sorted[i] = canonical({map(triangles[3 * i]), map(triangles[3 * i + 1]), map(triangles[3 * i + 2])});
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

bool all_distinct(std::span<const std::uint32_t> order, std::size_t bound) {
  std::vector<bool> seen(bound);
  for (const std::uint32_t v : order) {
    if (seen[v]) return false;
    seen[v] = true;
  }
  return true;
}

}  // namespace

bool triangles_correspond(std::span<const std::uint32_t> a, std::size_t a_vertices,
                          std::span<const std::uint32_t> b, std::span<const std::uint32_t> order) {
  if (a.size() != b.size() || !all_distinct(order, a_vertices)) return false;
  return sorted_triangles(a, [](std::uint32_t v) { return v; }) ==
         sorted_triangles(b, [order](std::uint32_t v) { return order[v]; });
}

}  // namespace deltamesh
