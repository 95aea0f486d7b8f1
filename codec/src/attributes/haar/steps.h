// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How fine the difference of two children is coded, by their weights [HAAR-10].
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace deltamesh {

struct HaarStep {
  std::uint32_t size;       ///< of a difference, 64ths of a level, 1 at least
  std::uint32_t per_value;  ///< 2^20 / size, rounded down
};

/// The error of a difference x1 - x2 of means of w1 and w2 values adds w1 w2 / (w1 + w2) times its square to
/// the sum of all squared errors: with these steps, those of all differences count the same.
class HaarSteps {
 public:
  /// `step`: of a coefficient, 64ths of a level, 1 to 65535.
  explicit HaarSteps(std::uint32_t step) noexcept : square_(std::uint64_t{step} * step) {
    for (std::uint32_t a = 1; a < kFew; ++a)
      for (std::uint32_t b = 1; b < kFew; ++b) few_[a * kFew + b] = compute(a, b);
  }

  HaarStep of(std::uint32_t a, std::uint32_t b) const noexcept {
    return a < kFew && b < kFew ? few_[a * kFew + b] : compute(a, b);
  }

 private:
  static constexpr std::uint32_t kFew = 16;

  HaarStep compute(std::uint32_t a, std::uint32_t b) const noexcept {
    // At most 2^33, so that the root of the double is that of the whole number.
    const std::uint64_t square = square_ * (std::uint64_t{a} + b) / (std::uint64_t{a} * b);
    const auto size = std::max(static_cast<std::uint32_t>(std::sqrt(static_cast<double>(square))), 1U);
    return {.size = size, .per_value = (1U << 20) / size};
  }

  std::uint64_t square_;
  std::array<HaarStep, std::size_t{kFew} * kFew> few_{};
};

}  // namespace deltamesh
