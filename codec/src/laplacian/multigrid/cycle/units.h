// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Positions as whole numbers of a unit: differences of large numbers lose nothing, at half of what doubles
// cost.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/numbers/vec3.h"
#include "base/simd/four_ints.h"
#include "laplacian/multigrid/level/row.h"
#include "laplacian/operator/delta_view.h"

namespace deltamesh::multigrid {

/// Two's complement: counts from 2^31 on are negative, and may wrap.
using Counts = FourUnsigned;

/// A unit is 2^-bits steps of the deltas. Sums of positions are exact modulo 2^32 units, so a residual is
/// right if it is itself below 2^31 units.
class Units {
 public:
  /// `reach`: about the largest coordinate at the start, in steps. Coordinates above 16 times as much wrap.
  /// If it is not finite, no position will be.
  Units(const DeltaView& deltas, float reach) noexcept
      : bits_(bits_for(deltas, reach)),
        per_step_(std::ldexp(1.0F, bits_)),
        step_(std::ldexp(1.0F, -bits_)),
        unit_(std::isfinite(reach) ? std::ldexp(deltas.scale().step, -bits_) : static_cast<double>(reach)) {}

  int bits() const noexcept { return bits_; }

  float per_step() const noexcept { return per_step_; }

  /// Rounds to the nearest whole number of units, ties to even; -2^31 if out of range.
  static Counts nearest(Float4 units) noexcept { return reinterpret_cast<Counts>(nearest_lanes(units)); }
  Counts count(Float4 steps) const noexcept { return nearest(per_step_ * steps); }

  static Float4 floats(Counts counts) noexcept { return to_floats(reinterpret_cast<FourInts>(counts)); }
  Float4 steps(Float4 units) const noexcept { return step_ * units; }

  /// Model units.
  Vec3 position(Counts counts) const noexcept {
    const auto signed_counts = reinterpret_cast<FourInts>(counts);
    return {unit_ * signed_counts[0], unit_ * signed_counts[1], unit_ * signed_counts[2]};
  }

 private:
  /// Bits of the largest coordinate at the start.
  static constexpr int kBits = 26;

  static int bits_for(const DeltaView& deltas, float reach) noexcept {
    if (!(reach > 0 && std::isfinite(reach))) return 0;
    const int bits = kBits - std::ilogb(reach);
    return deltas.has_symbols() ? std::clamp(bits, 0, DeltaCounts::kMostBits) : std::clamp(bits, -126, 126);
  }

  int bits_;
  float per_step_;
  float step_;   ///< a unit, in steps
  double unit_;  ///< model units
};

/// Checks that all values seen are well below 2^31 units. The margin is for rounding: values are floats, with
/// errors up to 2^-24 of the terms that they are sums of.
class RangeWatch {
 public:
  void see(Float4 units) noexcept {
    const Float4 size = units < 0 ? -units : units;
    for (std::size_t axis = 0; axis < 3; ++axis) holds_ &= size[axis] < kMost;  // not if it is not a number
  }
  bool holds() const noexcept { return holds_; }

 private:
  static constexpr float kMost = 0x1.fp30F;
  bool holds_ = true;
};

}  // namespace deltamesh::multigrid
