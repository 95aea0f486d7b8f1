// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Key of a part of a map: a cell of an octree.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace deltamesh {

/// Cells of level 0 are the smallest; one of level l has 2^l times their edge.
inline constexpr std::uint8_t kMostPartLevel = 24;  // [MAP-3]

/// The cell [x, x + 1) x [y, y + 1) x [z, z + 1), counted in edges of its level from the map's origin. Keys
/// of one map are ordered by level, then x, y, z.
struct PartKey {
  std::uint8_t level = 0;  ///< at most kMostPartLevel
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t z = 0;

  auto operator<=>(const PartKey&) const = default;
};

/// The key of `level`, not below that of `key`, whose cell holds that of `key`.
constexpr PartKey ancestor(const PartKey& key, std::uint8_t level) noexcept {
  const int up = level - key.level;
  return {level, key.x >> up, key.y >> up, key.z >> up};
}

/// Whether the cells have a point inside both.
constexpr bool overlap(const PartKey& a, const PartKey& b) noexcept {
  return a.level <= b.level ? ancestor(a, b.level) == b : ancestor(b, a.level) == a;
}

/// The keys of the parts that show the map on a level: parts of that level or above that contain no other
/// such part, which leaves out coarser copies [MAP-19]. `keys`: all keys of the map, ascending; the result is
/// ascending too. O(n log n).
std::vector<PartKey> keys_on_level(std::span<const PartKey> keys, std::uint8_t level);

/// The highest level on which parts show all that they show on level 0; on higher ones something is left out,
/// as it has no coarser copy there. `keys`: likewise; 0 without any. O(n log n).
std::uint8_t top_level(std::span<const PartKey> keys);

}  // namespace deltamesh
