// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The part of the header that belongs to the predictive geometry coder.
#pragma once

#include <array>
#include <cstdint>

#include "base/numbers/vec3.h"

namespace deltamesh {

inline constexpr std::uint32_t kMostCells = 1U << 28;  ///< largest lattice coordinate [HDR-14]

/// Largest `first` of a lattice, either sign. Whole steps from the origin stay exact doubles [HDR-14].
inline constexpr std::int64_t kMostFirst = std::int64_t{1} << 48;

/// The points origin + step * (first + q), q whole and 0 to `cells` on each axis [POSN-2]. Lattices of the
/// same step and origin have their points in common, bit by bit, wherever they start.
struct PositionLattice {
  Vec3 origin{};                         ///< model units, finite
  std::array<std::int64_t, 3> first{};   ///< in steps from the origin, at most kMostFirst in size
  Vec3 step{1, 1, 1};                    ///< model units, finite, above 0
  std::array<std::uint32_t, 3> cells{};  ///< at most kMostCells

  /// `q`: whole, 0 to `cells`; its sum with `first` is exact.
  double at(std::size_t axis, double q) const noexcept {
    return origin[axis] + step[axis] * (static_cast<double>(first[axis]) + q);
  }
};

/// The kind of positions: of POSN [POSN-1], or kVoxel, of GRID [GRD-12].
enum class PositionKind : std::uint8_t { kLattice, kVoxel, kFloats };

inline constexpr std::uint32_t kMostLevels = 1U << 19;  ///< along the edge of a voxel [HDR-14]

/// The header's fields for a predictive stream [HDR-14].
struct PredictiveParameters {
  std::uint8_t bits = 0;  ///< asked bits, 1 to 28; 0 where something else was asked. For information
  PositionKind kind = PositionKind::kLattice;
  PositionLattice lattice;
  std::uint32_t levels = 1;  ///< of kVoxel: parts of an edge; a voxel is 2 * levels steps
};

}  // namespace deltamesh
