// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/haar/levels/places.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace deltamesh {
namespace {

struct HaarExtent {
  double low = 0;
  double high = 0;
};

HaarExtent haar_extent(std::span<const float> positions, std::size_t axis) noexcept {
  HaarExtent range;
  bool is_first = true;
  for (std::size_t i = axis; i < positions.size(); i += 3) {
    const double x = static_cast<double>(positions[i]);
    if (!std::isfinite(x)) continue;
    range.low = is_first ? x : std::min(range.low, x);
    range.high = is_first ? x : std::max(range.high, x);
    is_first = false;
  }
  return range;
}

}  // namespace

LargeVector<HaarPlace> make_haar_places(std::span<const float> positions, std::uint32_t vertex_count) {
  LargeVector<HaarPlace> places(vertex_count, HaarPlace{});
  if (positions.empty()) return places;
  std::array<HaarExtent, 3> ranges;
  double extent = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    ranges[axis] = haar_extent(positions, axis);
    extent = std::max(extent, ranges[axis].high - ranges[axis].low);
  }
  if (extent == 0) return places;
  // The extent becomes 2^19 to 2^20, by a power of two: products are exact.
  int exponent = 0;
  std::frexp(extent, &exponent);
  const double scale = std::ldexp(1.0, static_cast<int>(kHaarPlaceBits) - exponent);
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double x = static_cast<double>(positions[std::size_t{3} * v + axis]);
      if (!std::isfinite(x)) continue;
      // Below 2^20, as no difference is rounded to more than the extent.
      places[v][axis] = static_cast<std::int32_t>((x - ranges[axis].low) * scale);
    }
  }
  return places;
}

}  // namespace deltamesh
