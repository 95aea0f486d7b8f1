// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Finds the part of every cell of level 0: a cell of the octree.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "deltamesh/map/part_key.h"
#include "split/stored_block.h"

namespace deltamesh {

/// The largest parts.
struct PartSize {
  std::uint64_t most_triangles = 0;
  std::uint8_t most_level = 0;
};

/// How many triangles every cell of the octree has.
class Octree {
 public:
  /// Of a cell of level 0. O(levels * log n), as what follows.
  void add(const Cell0& cell, std::uint64_t triangles);
  void remove(const Cell0& cell, std::uint64_t triangles);

  bool contains(const PartKey& key) const { return triangles_.contains(key); }
  /// The largest cell of up to `most_level` that holds `cell` and has at most `most_triangles`, or itself.
  PartKey part_of(const Cell0& cell, const PartSize& size) const;
  /// Cells of level 0 with triangles. O(levels * log n) for each.
  void add_cells_in(const PartKey& key, std::vector<Cell0>& cells) const;
  /// All of them.
  std::map<Cell0, std::uint64_t> cells() const;

 private:
  std::uint64_t triangles_in(const PartKey& key) const;

  std::map<PartKey, std::uint64_t> triangles_;  ///< without cells that have none
};

/// Ascending. Precondition: a level above 0.
constexpr std::array<PartKey, 8> children_of(const PartKey& key) noexcept {
  std::array<PartKey, 8> children{};
  for (int i = 0; i < 8; ++i)
    children[static_cast<std::size_t>(i)] = {static_cast<std::uint8_t>(key.level - 1), 2 * key.x + (i >> 2),
                                             2 * key.y + (i >> 1 & 1), 2 * key.z + (i & 1)};
  return children;
}

inline PartKey key_of(const Cell0& cell) noexcept { return {0, cell[0], cell[1], cell[2]}; }

}  // namespace deltamesh
