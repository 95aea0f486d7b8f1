// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Finds keys of parts whose cells overlap a cell.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "deltamesh/map/part_key.h"

namespace deltamesh {

/// Of an entry of a set or a map.
inline const PartKey& key_of(const PartKey& entry) noexcept { return entry; }
template <class Value>
const PartKey& key_of(const std::pair<const PartKey, Value>& entry) noexcept {
  return entry.first;
}

/// Those of `keys`, a set or a map of them, that overlap `key`, and that itself if it is there; ascending. Of
/// each level below it looks at those between the cell's ends on the first axis alone.
template <class Keys>
std::vector<PartKey> overlapping(const Keys& keys, const PartKey& key) {
  using Limits = std::numeric_limits<std::int32_t>;
  std::vector<PartKey> found;
  if (keys.empty()) return found;
  const auto level_of = [](const auto& entry) { return int{key_of(*entry).level}; };
  for (int level = level_of(keys.begin()); level < key.level; ++level) {
    const std::int64_t edge = std::int64_t{1} << (key.level - level);
    const std::int64_t low = std::max<std::int64_t>(edge * key.x, Limits::min());
    if (low > Limits::max()) continue;
    const PartKey first{static_cast<std::uint8_t>(level), static_cast<std::int32_t>(low), Limits::min(),
                        Limits::min()};
    for (auto it = keys.lower_bound(first); it != keys.end() && level_of(it) == level; ++it) {
      const PartKey& other = key_of(*it);
      if (other.x >= edge * (std::int64_t{key.x} + 1)) break;
      if (overlap(other, key)) found.push_back(other);
    }
  }
  for (int level = key.level; level <= level_of(std::prev(keys.end())); ++level)
    if (const PartKey around = ancestor(key, static_cast<std::uint8_t>(level)); keys.contains(around))
      found.push_back(around);
  return found;
}

}  // namespace deltamesh
