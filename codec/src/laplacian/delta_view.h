// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Delta coordinates as the solvers read them: doubles, or the whole numbers that a stream codes them as.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/four_ints.h"
#include "base/two_doubles.h"
#include "base/vec3.h"

namespace deltamesh {

/// What a symbol q stands for: 0 where it is 0, else step (|q| - shift) with the sign of q, the shift being
/// shifts[1] where |q| = 1 and shifts[2] where it is larger [DELT-2].
struct DeltaScale {
  double step = 1;                 ///< model units
  std::array<double, 3> shifts{};  ///< in steps, below 1; that of 0 is 0

  /// Without branches, which could not be predicted.
  double value(std::int32_t q) const noexcept {
    const double size = std::abs(static_cast<double>(q));
    const std::uint32_t bin =
        std::min(q < 0 ? 0 - static_cast<std::uint32_t>(q) : static_cast<std::uint32_t>(q), 2U);
    return step * std::copysign(size - shifts[bin], static_cast<double>(q));
  }

  /// The same of two symbols, in other units: `steps` each.
  TwoDoubles values(TwoDoubles q, double steps) const noexcept {
    const TwoDoubles size = q < 0 ? -q : q;
    const TwoDoubles shift =
        size == 1 ? TwoDoubles{} + shifts[1] : (size > 1 ? TwoDoubles{} + shifts[2] : TwoDoubles{});
    const TwoDoubles moved = size - shift;
    return steps * (q < 0 ? -moved : moved);
  }
};

/// x, y, z and 0 as the nearest whole numbers, and what these leave, at most a half.
struct WholeAndRest {
  FourInts whole;
  FourFloats rest;
};

inline WholeAndRest split(TwoDoubles xy, TwoDoubles z0) noexcept {
  const FourInts whole = nearest_lanes(xy, z0);
  return {whole, narrow_lanes(xy - low_doubles(whole), z0 - high_doubles(whole))};
}

/// Owns nothing.
class DeltaView {
 public:
  DeltaView() = default;
  DeltaView(std::span<const Vec3> values)  // NOLINT(google-explicit-constructor): doubles are the rule
      : values_(values), size_(values.size()) {}
  DeltaView(const std::vector<Vec3>& values)  // NOLINT(google-explicit-constructor)
      : values_(values), size_(values.size()) {}
  /// `symbols`: x of all rows, then y, then z.
  DeltaView(std::span<const std::int32_t> symbols, const DeltaScale& scale)
      : symbols_(symbols), scale_(scale), size_(symbols.size() / 3) {}

  std::size_t size() const noexcept { return size_; }

  Vec3 operator[](std::size_t i) const noexcept {
    if (symbols_.empty()) return values_[i];
    return {scale_.value(symbols_[i]), scale_.value(symbols_[size_ + i]),
            scale_.value(symbols_[2 * size_ + i])};
  }

  /// In some unit of which there are `per_length`, a power of two, in a model unit.
  WholeAndRest in_units(std::size_t i, double per_length) const noexcept {
    if (symbols_.empty()) {
      const Vec3& v = values_[i];
      return split(per_length * TwoDoubles{v[0], v[1]}, per_length * TwoDoubles{v[2], 0.0});
    }
    const FourInts q{symbols_[i], symbols_[size_ + i], symbols_[2 * size_ + i], 0};
    const double steps = per_length * scale_.step;
    return split(scale_.values(low_doubles(q), steps), scale_.values(high_doubles(q), steps));
  }

 private:
  std::span<const Vec3> values_;
  std::span<const std::int32_t> symbols_;
  DeltaScale scale_;
  std::size_t size_ = 0;
};

}  // namespace deltamesh
