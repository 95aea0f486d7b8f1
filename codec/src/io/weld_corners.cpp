// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/weld_corners.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <numeric>

namespace deltamesh {
namespace {

using Key = std::array<std::uint64_t, 3>;

Key key_of(std::span<const double> coordinates, std::size_t corner) noexcept {
  Key key{};
  // Adding 0 turns -0 into 0 and changes nothing else.
  for (std::size_t k = 0; k < 3; ++k)
    key[k] = std::bit_cast<std::uint64_t>(coordinates[3 * corner + k] + 0.0);
  return key;
}

}  // namespace

// Sorting instead of hashing: no input can make it slow, and the result does not depend on a hash.
WeldedCorners weld_corners(std::span<const double> coordinates) {
  const std::size_t corners = coordinates.size() / 3;
  std::vector<std::uint32_t> order(corners);
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Key key_a = key_of(coordinates, a);
    const Key key_b = key_of(coordinates, b);
    return key_a != key_b ? key_a < key_b : a < b;
  });
  std::vector<std::uint32_t> first(corners);  // the first corner at this point
  for (std::size_t i = 0; i < corners; ++i) {
    const bool again = i > 0 && key_of(coordinates, order[i]) == key_of(coordinates, order[i - 1]);
    first[order[i]] = again ? first[order[i - 1]] : order[i];
  }

  WeldedCorners welded;
  welded.corners.resize(corners);
  for (std::size_t c = 0; c < corners; ++c) {
    if (first[c] != c) {
      welded.corners[c] = welded.corners[first[c]];
      continue;
    }
    welded.corners[c] = static_cast<std::uint32_t>(welded.coordinates.size() / 3);
    for (std::size_t k = 0; k < 3; ++k) welded.coordinates.push_back(coordinates[3 * c + k] + 0.0);
  }
  return welded;
}

}  // namespace deltamesh
