// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Positions as whole numbers of a unit: differences of large numbers lose nothing, at half of what doubles
// cost.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/four_ints.h"
#include "base/vec3.h"
#include "laplacian/multigrid_row.h"

namespace deltamesh::multigrid {

/// Sums of positions are right modulo 2^32 units, so a residual is right where it is below 2^31 units itself.
class Units {
 public:
  /// `reach`: the largest coordinate at the start, about; what goes beyond 8 times as much turns around.
  /// Where that is not finite, no position will be.
  explicit Units(float reach) noexcept
      : unit_(std::isfinite(reach) ? std::ldexp(1.0F, exponent_for(reach)) : reach), per_length_(1 / unit_) {}

  /// The nearest whole number, of two that of the even one; -2^31 where there is none.
  FourInts count(Float4 lengths) const noexcept { return nearest_lanes(per_length_ * lengths); }

  float per_length() const noexcept { return per_length_; }

  /// Of counts + rest units.
  Float4 length(FourInts counts, Float4 rest) const noexcept {
    return unit_ * (__builtin_convertvector(counts, Float4) + rest);
  }

  Vec3 position(FourInts counts) const noexcept {
    const double unit = unit_;
    return {unit * counts[0], unit * counts[1], unit * counts[2]};
  }

 private:
  /// Of the largest coordinate at the start.
  static constexpr int kBits = 27;

  /// Neither the unit nor one over it is out of the range of floats.
  static int exponent_for(float reach) noexcept {
    return reach > 0 ? std::clamp(std::ilogb(reach) - kBits, -126, 126) : 0;
  }

  float unit_;        ///< a power of two
  float per_length_;  ///< 1 / unit_
};

}  // namespace deltamesh::multigrid
