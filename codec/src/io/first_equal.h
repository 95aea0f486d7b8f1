// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Finds equal elements of a list. Sorts instead of hashing, so that no input can make it slow.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace deltamesh {

/// For each of `count` things, at most 2^32 - 1, the first one whose `key` is equal. O(count log count).
template <class Key>
std::vector<std::uint32_t> first_equal(std::size_t count, Key key) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto compared = key(a) <=> key(b);
    return compared != 0 ? compared < 0 : a < b;
  });
  std::vector<std::uint32_t> first(count);
  for (std::size_t i = 0; i < count; ++i) {
    const bool again = i > 0 && key(order[i]) == key(order[i - 1]);
    first[order[i]] = again ? first[order[i - 1]] : order[i];
  }
  return first;
}

}  // namespace deltamesh
