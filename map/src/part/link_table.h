// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The links of a map's parts [MAP-12], kept as parts change.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <unordered_map>
#include <vector>

#include "deltamesh/map/part.h"
#include "deltamesh/map/part_entry.h"
#include "lattice/positions.h"

namespace deltamesh {

struct SharedPoint {
  LatticePoint point{};
  std::uint32_t twin = 0;

  auto operator<=>(const SharedPoint&) const = default;
};

struct SharedPointHash {
  std::size_t operator()(const SharedPoint& shared) const noexcept {
    return PositionHash{}(shared.point) ^ shared.twin;
  }
};

class LinkTable {
 public:
  /// Puts a part in the place of the one with its key. O(b log b) for b border vertices.
  void put(const MapPart& part);
  void remove(const PartKey& key);

  /// With every border, none marked; without parts whose cells overlap. O(b log n).
  std::vector<PartLink> links_of(const PartKey& key) const;
  /// How many points users of different cells of `level` have in common; of parts up to that level. O(b log
  /// b).
  std::size_t count_between_cells(std::uint8_t level, const std::set<PartKey>& without) const;
  /// Parts whose links may be others than at the last call, ascending; also those that are gone.
  std::set<PartKey> take_touched();

 private:
  void set(const PartKey& key, const std::vector<SharedPoint>& points);

  std::map<PartKey, std::vector<SharedPoint>> borders_;  ///< ascending, without duplicates
  std::unordered_map<SharedPoint, std::vector<PartKey>, SharedPointHash> users_;
  std::set<PartKey> touched_;
};

}  // namespace deltamesh
