// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The positions that an adapter's blocks have.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "lattice/positions.h"

namespace deltamesh {

/// Finds positions within a tolerance in a grid whose cells are four times the tolerance wide: a position
/// looks into 8 cells at most, mostly into 1 or 2, and as known positions are farther apart than the
/// tolerance when they become known, a cell has few.
class KnownPositions {
 public:
  using Position = std::array<float, 3>;
  /// `step`: of the map's lattice; positions are less than 2^24 steps from the origin.
  KnownPositions(double tolerance, double step);

  /// The nearest known position within the tolerance, of equally near ones the least; else `position`, which
  /// is known from then on. O(1) expected. `used` gets it if it is the first time since begin_block().
  Position settle(const Position& position, std::vector<Position>& used);
  void begin_block() noexcept { ++block_; }
  /// Forgets a block's use of positions; those that no block uses are no longer known.
  void release(const std::vector<Position>& used);

 private:
  using GridCell = std::array<std::int64_t, 3>;
  struct Known {
    Position position{};
    std::uint32_t uses = 0;       ///< by blocks
    std::uint64_t last_used = 0;  ///< in which block
  };

  GridCell cell_of(const Position& position, double shift) const noexcept;
  Known* nearest(const Position& position);

  double tolerance_;
  double width_;
  std::uint64_t block_ = 0;
  std::unordered_multimap<GridCell, Known, PositionHash> known_;
};

}  // namespace deltamesh
