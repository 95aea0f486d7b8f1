// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "topology/extent.h"

#include <algorithm>
#include <vector>

namespace deltamesh {
namespace {

constexpr std::size_t kSample = std::size_t{1} << 15;
constexpr std::size_t kTrimmed =
    1000;  ///< one in so many is no part of the inner box, at either end of an axis
constexpr std::uint64_t kMostShare = 100;  ///< strays are at most one in so many
constexpr std::size_t kFewest = 500;       ///< vertices

/// The box that has all but a thousandth at either end of every axis, but at least the two outermost.
Box inner_box(std::span<const Vec3> positions) {
  Box inner;
  std::vector<double> values;
  const std::size_t stride = positions.size() / kSample + 1;
  for (std::size_t k = 0; k < 3; ++k) {
    values.clear();
    for (std::size_t i = 0; i < positions.size(); i += stride) values.push_back(positions[i][k]);
    const auto trimmed = static_cast<std::ptrdiff_t>(std::max<std::size_t>(values.size() / kTrimmed, 2));
    const auto low = values.begin() + trimmed;
    const auto high = values.end() - 1 - trimmed;
    std::nth_element(values.begin(), low, values.end());
    inner.min[k] = *low;
    std::nth_element(low, high, values.end());
    inner.max[k] = *high;
  }
  return inner;
}

}  // namespace

Extent extent_of(std::span<const Vec3> positions, const Box& box) {
  Extent extent{.diagonal = box.diagonal()};
  if (positions.size() < kFewest) return extent;
  Box reach = inner_box(positions);
  const double side = reach.longest_side();
  for (std::size_t k = 0; k < 3; ++k) {
    reach.min[k] -= side;
    reach.max[k] += side;
  }
  const Extent candidate{.strays = 1, .reach = reach};
  Box rest = Box::empty();
  std::uint64_t strays = 0;
  for (const Vec3& p : positions) {
    if (candidate.is_stray(p))
      ++strays;
    else
      rest.add(p);
  }
  if (!(side > 0) || strays == 0 || strays > std::max<std::uint64_t>(positions.size() / kMostShare, 2))
    return extent;
  return {.diagonal = rest.diagonal(), .strays = strays, .reach = reach};
}

}  // namespace deltamesh
