// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Predictions of a vertex' numbers, axis by axis: sign, scale and contexts. Integers only; shared by writer
// and reader [FLD-14, FLD-15]. No branches on the data, as they would often be mispredicted.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "field/field_history.h"
#include "field/octave_class.h"

namespace deltamesh {

/// How many models a number has, and contexts each of them [FLD-15].
inline constexpr std::size_t kFieldModels = 2;
inline constexpr std::array<std::uint32_t, kFieldModels> kFieldContexts = {24 * 8, 12 * 12 * 3 * 8 * 2};

/// Prediction of one number.
struct FieldPrediction {
  std::int32_t base = 0;  ///< what is subtracted
  std::int32_t sign = 0;  ///< -1 where signs are swapped, else 0
  unsigned shift = 0;     ///< low bits outside the symbol
  std::array<std::uint32_t, kFieldModels> contexts{};
};

/// Predictions of the three numbers of a vertex. Call of<0>(), settle<0>(), of<1>(), settle<1>(), of<2>(),
/// settle<2>().
class FieldPredictions {
 public:
  [[gnu::always_inline]] explicit FieldPredictions(const FieldContext& around) noexcept : around_(around) {
    if_close_ = 2 * sum_of(around.errors) < sum_of(around.sizes) ? -1 : 0;
    sizes_ = (around.errors & if_close_) | (around.sizes & ~if_close_);
    bases_ = around.last_peer & if_close_;
    halves_ = (around.numbers - (bases_ << 4)) >> 1;
  }

  template <unsigned kAxis>
  [[gnu::always_inline]] FieldPrediction of() const noexcept {
    const std::int32_t mean = expected<kAxis>();
    const std::int32_t size = sizes_[kAxis];
    const std::int32_t coded = kAxis == 1 ? 2 * coded_ : coded_;
    const std::int32_t scale = ((5 * size + coded) >> 3) + 1;
    FieldPrediction f;
    f.base = bases_[kAxis];
    f.sign = mean >> 31;
    f.shift = static_cast<unsigned>(std::bit_width(static_cast<std::uint32_t>(scale) | 63)) - 6;
    const std::int32_t far = (mean ^ f.sign) - f.sign;
    const std::uint32_t sure =
        (8 * far >= scale ? 1U : 0U) + (2 * far >= scale ? 1U : 0U) + (far >= scale ? 1U : 0U);
    const std::uint32_t close = static_cast<std::uint32_t>(if_close_) & 1;
    const std::uint32_t coded_class = kOctaveClass[static_cast<std::uint32_t>(coded) >> f.shift] / 2U;
    const std::uint32_t size_class = kOctaveClass[static_cast<std::uint32_t>(size) >> f.shift] / 2U;
    f.contexts = {(kOctaveClass[static_cast<std::uint32_t>(scale) >> f.shift] * 4U + sure) * 2 + close,
                  (((coded_class * 12 + size_class) * 3 + kAxis) * 8 + around_.degree_class) * 2 + close};
    return f;
  }

  /// `q`: the number that was coded.
  template <unsigned kAxis>
  [[gnu::always_inline]] void settle(std::int32_t q) noexcept {
    numbers_[kAxis] = std::clamp(q, -kLargestRemembered, kLargestRemembered);
    if constexpr (kAxis < 2) coded_ += 8 * std::abs(numbers_[kAxis] - bases_[kAxis]);
  }

  /// All that were settled, cut to kLargestRemembered; the others are 0.
  const std::array<std::int32_t, 3>& numbers() const noexcept { return numbers_; }

 private:
  static std::int32_t sum_of(FourInts lanes) noexcept { return lanes[0] + lanes[1] + lanes[2]; }
  static std::int32_t sign_of(std::int32_t x) noexcept { return (x > 0 ? 1 : 0) - (x < 0 ? 1 : 0); }

  /// Expected number relative to the base, sixteenths of a step.
  template <unsigned kAxis>
  [[gnu::always_inline]] std::int32_t expected() const noexcept {
    const std::int32_t half = halves_[kAxis];
    if constexpr (kAxis == 0) return half;
    const FourInts ties = around_.ties & ~if_close_;
    if constexpr (kAxis == 1) return half + sign_of(numbers_[0]) * ties[0];
    return half + sign_of(numbers_[0]) * ties[1] + sign_of(numbers_[1]) * ties[2];
  }

  const FieldContext& around_;
  std::int32_t if_close_ = 0;  ///< -1 where numbers are coded as differences to the last peer, else 0
  FourInts sizes_{};
  FourInts bases_{};
  FourInts halves_{};       ///< of the mean of what is coded, sixteenths
  std::int32_t coded_ = 0;  ///< half of what was coded so far, without signs, in sixteenths
  std::array<std::int32_t, 3> numbers_{};
};

}  // namespace deltamesh
