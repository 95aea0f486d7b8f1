// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The borders of all parts, kept as blocks change.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "deltamesh/map/description.h"
#include "deltamesh/map/part_key.h"
#include "lattice/positions.h"
#include "split/position_table.h"

namespace deltamesh {

/// A position that faces of several parts have [MAP-8].
struct BorderPosition {
  PositionBits position{};
  LatticePoint point{};
  std::uint32_t twin = 0;

  auto operator<=>(const BorderPosition&) const = default;
};

/// That a part has a border position.
struct BorderUse {
  LatticePoint point{};
  PositionBits position{};
  std::uint32_t twin = 0;
  PartKey part{};

  auto operator<=>(const BorderUse&) const = default;
};

struct BorderChange {
  std::set<PartKey> changed;                    ///< parts whose border is not as before
  std::set<PartKey> touched;                    ///< these, and parts that have the same positions
  std::set<std::pair<PartKey, PartKey>> pairs;  ///< that have other positions in common; lower keys first
};

class Borders {
 public:
  explicit Borders(const MapLattice& lattice) : lattice_(lattice) {}

  /// For so many more vertices in blocks to add.
  void reserve(std::size_t vertices) { positions_.reserve(vertices); }
  /// Blocks stay where they are in memory until they are removed, with the mesh that they were added with.
  /// O(n log n) for n vertices.
  void add(const PlacedBlock& block);
  void remove(const PlacedBlock& block);

  /// All uses of positions that several parts have now. `points`: ascending, without duplicates; the result
  /// is ascending as well.
  std::vector<BorderUse> at(std::span<const LatticePoint> points) const;
  /// Takes over what has changed from at() to at() of the same points.
  BorderChange change(const std::vector<BorderUse>& before, const std::vector<BorderUse>& after);

  /// Ascending.
  const std::vector<BorderPosition>& of(const PartKey& part) const;
  /// Of the part's border, those positions that parts outside of `cell` have.
  std::vector<BorderPosition> outside(const PartKey& part, const PartKey& cell) const;

 private:
  using Users = std::vector<std::pair<PositionBits, const PlacedBlock*>>;
  void uses_at(const LatticePoint& point, std::vector<BorderUse>& uses) const;
  void share(const PositionBits& position, const PlacedBlock& block);
  void unshare(const PositionBits& position, const PlacedBlock& block);

  MapLattice lattice_;
  PositionTable positions_;
  std::unordered_map<LatticePoint, Users, PositionHash> shared_;  ///< positions that several blocks have
  std::map<PartKey, std::vector<BorderPosition>> borders_;        ///< without empty ones
};

/// The lattice points of the blocks' vertices, ascending, without duplicates.
std::vector<LatticePoint> points_of(std::span<const Mesh* const> meshes, const MapLattice& lattice);

}  // namespace deltamesh
