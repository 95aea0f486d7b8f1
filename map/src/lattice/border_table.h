// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The positions that faces of several parts have [MAP-8].
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/map/description.h"
#include "deltamesh/mesh.h"

namespace deltamesh {

/// A position by its bits.
using PositionBits = std::array<std::uint32_t, 3>;
PositionBits bits_of(const Mesh& mesh, std::size_t vertex) noexcept;

struct BorderPosition {
  PositionBits position{};
  LatticePoint point{};
  std::uint32_t twin = 0;

  auto operator<=>(const BorderPosition&) const = default;
};

/// One part's use of a border position.
struct BorderUse {
  LatticePoint point{};
  PositionBits position{};
  std::uint32_t part = 0;
  std::uint32_t twin = 0;

  auto operator<=>(const BorderUse&) const = default;
};

/// Collects all positions of a map, part by part.
class BorderTable {
 public:
  explicit BorderTable(const MapLattice& lattice) : lattice_(lattice) {}

  void add(const Mesh& mesh, std::uint32_t part);
  /// Every use of a position that several parts have, ascending by point, position and part. O(n log n).
  std::vector<BorderUse> finish();

 private:
  MapLattice lattice_;
  std::vector<BorderUse> uses_;
};

/// The border of each of `count` parts, ascending by position.
std::vector<std::vector<BorderPosition>> borders_of_parts(std::span<const BorderUse> uses, std::size_t count);

}  // namespace deltamesh
