// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From a delta coordinate to its symbol and back.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>

#include "base/vec3.h"
#include "format/highpass_parameters.h"

namespace deltamesh {

/// The number, in steps, that symbol `q` stands for: `q` moved towards 0 by shift_one / 256 where |q| = 1, by
/// shift_more / 256 where it is larger [DELT-2]. Exact in double precision.
inline double reconstruction_point(std::int32_t q, const ReconstructionShift& shift) noexcept {
  if (q == 0) return 0;
  const int towards_zero = q == 1 || q == -1 ? shift.one : shift.more;
  const double magnitude = std::abs(static_cast<double>(q)) - towards_zero / 256.0;
  return q < 0 ? -magnitude : magnitude;
}

/// Largest magnitude of a symbol that an encoder makes.
inline constexpr double kLargestSymbol = 1 << 30;

struct DeltaQuantizer {
  double step = 1;  ///< model units
  /// Added to |delta| / step before the fraction is cut off: 0.5 takes the nearest symbol, less moves symbols
  /// towards zero, where they are cheaper.
  double rounding = 0.5;
  ReconstructionShift shift{};

  /// A whole number, to be checked against kLargestSymbol.
  double symbol(double delta) const noexcept {
    return std::copysign(std::floor(std::abs(delta) / step + rounding), delta);
  }
  double value(std::int32_t q) const noexcept { return step * reconstruction_point(q, shift); }
};

/// The shift that brings the reconstruction points to the centroids of their bins, for `deltas` quantised one
/// by one. Its own `shift` is ignored. O(n).
ReconstructionShift centroid_shift(const DeltaQuantizer& quantizer, std::span<const Vec3> deltas) noexcept;

}  // namespace deltamesh
