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
};

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

 private:
  std::span<const Vec3> values_;
  std::span<const std::int32_t> symbols_;
  DeltaScale scale_;
  std::size_t size_ = 0;
};

}  // namespace deltamesh
