// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What the coder of coefficients learns, and its contexts [HAAR-11, HAAR-12].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "attributes/haar/color_axes.h"
#include "attributes/haar/log_class.h"
#include "entropy/coder/split_number.h"
#include "entropy/coder/symbol_models.h"

namespace deltamesh {

/// Classes of sizes in 16ths of a step: four an octave of size + 2, from 0 on.
constexpr std::uint32_t haar_size_class(std::uint32_t size) noexcept { return log_class<2>(size + 2) - 4; }

inline constexpr std::uint32_t kMostHaarUnshifted = 63;  ///< larger sizes are shifted
inline constexpr std::size_t kHaarScaleClasses = 26;     ///< 21, and 5 of sizes that were shifted
inline constexpr std::size_t kHaarAroundClasses = 12;
inline constexpr std::size_t kHaarWeightClasses = 3;

/// Some 32 kB.
struct HaarModels {
  HaarModels() {
    for (std::size_t scale = 0; scale < kHaarScaleClasses; ++scale)
      symbols[0].fill(scale * kPerScale, kPerScale, fresh(scale));
    for (std::size_t around = 0; around < kHaarAroundClasses; ++around)
      symbols[1].fill(around * kPerAround, kPerAround, fresh(2 * around));
  }

  static constexpr std::size_t kPerScale = kHaarWeightClasses * kHaarAxes;
  static constexpr std::size_t kPerAround = kHaarAroundClasses * kHaarAxes;

  std::array<SymbolModels, 2> symbols{SymbolModels(kHaarScaleClasses * kPerScale),
                                      SymbolModels(kHaarAroundClasses* kPerAround)};
  std::array<MixWeights, (kHaarScaleClasses + 3) / 4 * kHaarAxes> weights;
  SplitNumberModels numbers;

  void limit_counts(std::uint8_t most) noexcept {
    for (SymbolModels& models : symbols) models.limit_counts(most);
    numbers.limit_counts(most);
  }

 private:
  /// Falls by size / (size + 12) from number to number on both sides of 0, sizes being the class's; 1 at
  /// least [HAAR-12].
  static SymbolModel fresh(std::size_t size_class) noexcept {
    const auto size = static_cast<std::uint32_t>((4 + size_class % 4) << (size_class / 4)) - 3;
    std::array<std::uint8_t, kSymbols> weights_of;
    std::uint32_t weight = 200;
    for (std::size_t k = 0; k <= 7; ++k) {
      weights_of[7 + k] = static_cast<std::uint8_t>(weight);
      weights_of[7 - k] = static_cast<std::uint8_t>(weight);
      weight = std::max(weight * size / (size + 12), 1U);
    }
    weights_of[15] = weights_of[14];
    return SymbolModel(weights_of);
  }
};

/// Of a number: what has been seen around, in 16ths of a step.
struct HaarContext {
  unsigned shift;  ///< low bits of the number, which its symbol leaves out
  std::size_t scale;
  std::array<std::size_t, 2> models;
  std::size_t weights;

  /// `spread`: of the values around; `coded`: mean size of the numbers of the axes before.
  HaarContext(std::uint32_t expected, std::uint32_t spread, std::uint32_t coded, std::size_t weight_class,
              std::size_t axis) noexcept
      : shift(shift_of(expected)),
        scale(haar_size_class(expected >> shift) + (shift > 0 ? 5 : 0)),
        models{(scale * kHaarWeightClasses + weight_class) * kHaarAxes + axis,
               (around_class(spread) * kHaarAroundClasses + around_class(coded)) * kHaarAxes + axis},
        weights(scale / 4 * kHaarAxes + axis) {}

 private:
  static unsigned shift_of(std::uint32_t expected) noexcept {
    return static_cast<unsigned>(std::bit_width(expected | kMostHaarUnshifted)) - 6;
  }
  std::size_t around_class(std::uint32_t size) const noexcept {
    const auto size_class = static_cast<std::int32_t>(haar_size_class(size) - 4 * shift);
    constexpr std::int32_t kMost = kHaarAroundClasses - 1;
    return static_cast<std::size_t>(std::clamp(size_class >> 1, 0, kMost));
  }
};

}  // namespace deltamesh
