// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Forecasts of a vertex' numbers, axis by axis: a mean, a scale and contexts. Integers only; shared by writer
// and reader [FLD-4, FLD-5]. Written without branches that hang on the data: these would cost more than all
// the rest.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "base/floor_log2.h"
#include "base/quick_ratio.h"
#include "field/field_classes.h"
#include "field/field_history.h"

namespace deltamesh {

/// How many models a number has, and contexts each of them [FLD-5].
inline constexpr std::size_t kFieldModels = 3;
inline constexpr std::array<std::uint32_t, kFieldModels> kFieldContexts = {24 * 6 * 5, 24 * 8 * 3 * 3,
                                                                           24 * 3 * 5 * 3};
inline constexpr std::uint32_t kFieldWeightSets = 18;
inline constexpr std::uint32_t kSurenesses = 6;

/// What a caller that predicts the numbers knows of a vertex; 1/16 steps [FLD-7].
struct FieldHint {
  std::array<std::int32_t, 3> spread{};  ///< how far apart the neighbours' values are, 0 to 2^17
  std::array<std::int32_t, 3> offset{};  ///< what rounding took off the prediction, -16 to 16
};

/// The forecast for one axis of one vertex.
struct FieldForecast {
  unsigned shift = 0;     ///< low bits outside the symbol [FLD-5]
  std::int32_t sign = 0;  ///< -1 where the mean is below 0 and signs are swapped, else 0
  std::array<std::uint32_t, kFieldModels> contexts{};
  std::uint32_t weight_set = 0;
  std::uint32_t sure = 0;  ///< of the mean: 0 to 5
};

/// Weights of the two features of a forecast by axis, parts of 65536, learnt from vertex to vertex [FLD-4].
struct FieldWeights {
  FourInts regression = {0, 65536, 65536, 0};
  FourInts mean = {0, 0, 0, 0};
};

/// Forecasts the three axes of a vertex in turn: forecast<0>(), settle<0>(), forecast<1>() and so on,
/// teach().
class FieldPredictor {
 public:
  /// `hint`: null where there is none.
  [[gnu::always_inline]] FieldPredictor(const FieldNeighborhood& around, const FieldHint* hint) noexcept
      : around_(around) {
    const FieldMemory& m = around.means;
    for (std::size_t a = 0; a < 3; ++a) size_[a] = own_[a] = m.magnitudes[a];
    if (hint != nullptr) {
      own_ = hint->spread;
      offset_ = hint->offset;
      for (std::size_t a = 0; a < 3; ++a) size_[a] = (4 * size_[a] + 5 * own_[a]) >> 3;
    }
    degree5_ = std::clamp<std::uint32_t>(around.degree_class, 1, 5) - 1;
    all_ = size_[0] + size_[1] + size_[2];
    begin_regression();
  }

  const FieldNeighborhood& around() const noexcept { return around_; }
  /// The numbers settled, cut to kLargestRemembered.
  const std::array<std::int32_t, 3>& numbers() const noexcept { return r_; }

  template <unsigned kAxis>
  [[gnu::always_inline]] FieldForecast forecast(const FieldWeights& weights) noexcept {
    regressions_[kAxis] = regress<kAxis>();
    std::int64_t mean = std::int64_t{weights.mean[kAxis]} * around_.means.numbers[kAxis];
    if constexpr (kAxis > 0) mean += std::int64_t{weights.regression[kAxis]} * regressions_[kAxis];
    expected_[kAxis] = static_cast<std::int32_t>(mean >> 16) + offset_[kAxis];
    const std::int32_t coded = coded_magnitude<kAxis>();
    const std::int32_t scale = expected_scale<kAxis>(coded);
    scales_[kAxis] = scale;
    FieldForecast f;
    f.shift = floor_log2(static_cast<std::uint32_t>(scale) | 63) - 5;
    f.sign = expected_[kAxis] >> 31;
    const std::int32_t distance = (expected_[kAxis] ^ f.sign) - f.sign;
    const std::uint32_t near = std::min(static_cast<std::uint32_t>(distance) >> f.shift, kLargestNear);
    const std::uint32_t short_scale = static_cast<std::uint32_t>(scale) >> f.shift;
    const std::uint32_t sure = kSureness[(near * kSixteenthsOf[short_scale]) >> 16];
    const std::uint32_t coded_class = kOctaveClass[static_cast<std::uint32_t>(coded) >> f.shift];
    const std::uint32_t own_class = kOctaveClass[static_cast<std::uint32_t>(own_[kAxis]) >> f.shift];
    const std::uint32_t scale_class = kScaleClass[short_scale + (f.shift > 0 ? 64 : 0)];
    const std::uint32_t degree = around_.degree_class;
    const std::uint32_t degree5 = degree5_;
    f.contexts = {(scale_class * 6 + sure) * 5 + degree5,
                  ((coded_class * 8 + degree) * 3 + kAxis) * 3 + kCoarseSureness[sure],
                  ((own_class * 3 + kNearClass[near]) * 5 + degree5) * 3 + kAxis};
    f.weight_set = scale_class / 4 * 3 + kAxis;
    f.sure = sure;
    return f;
  }

  template <unsigned kAxis>
  [[gnu::always_inline]] void settle(std::int32_t q) noexcept {
    r_[kAxis] = std::clamp(q, -kLargestRemembered, kLargestRemembered);
    errors_[kAxis] = r_[kAxis] * kFieldUnit - expected_[kAxis];
  }

  /// Sign-sign least mean squares with a dead zone; the first walk's vertices teach [FLD-4].
  [[gnu::always_inline]] void teach(FieldWeights& weights) const noexcept {
    const FourInts scales = lanes(scales_);
    const FourInts errors = lanes(errors_);
    const FourInts dead = scales >> 1;
    const FourInts small = scales >> 2;
    const FourInts above = errors > dead;
    const FourInts below = errors < -dead;
    weights.regression = moved(weights.regression, lanes(regressions_), small, above, below);
    weights.mean = moved(weights.mean, around_.means.numbers, small, above, below);
  }

 private:
  static FourInts lanes(const std::array<std::int32_t, 3>& x) noexcept {
    return FourInts{x[0], x[1], x[2], 0};
  }

  /// `weight` a step up where its feature has the sign of the error, a step down where it has the other.
  [[gnu::always_inline]] static FourInts moved(FourInts weight, FourInts feature, FourInts small,
                                               FourInts above, FourInts below) noexcept {
    constexpr std::int32_t kStep = 128;
    constexpr std::int32_t kMost = 4 * 65536;
    const FourInts positive = feature > small;
    const FourInts negative = feature < -small;
    const FourInts up = ((above & positive) | (below & negative)) & (weight < kMost);
    const FourInts down = ((above & negative) | (below & positive)) & (weight > -kMost);
    return weight + (up & kStep) - (down & kStep);
  }

  /// From the neighbours' second moments: how y and z hang on x, and what x leaves unexplained of z on what
  /// it leaves of y [FLD-4].
  [[gnu::always_inline]] void begin_regression() noexcept {
    constexpr std::int64_t kRidge = 5;
    const FourInts& m = around_.means.products;
    y_on_x_ = quick_ratio(m[1], m[0] + kRidge);
    z_on_x_ = quick_ratio(m[2], m[0] + kRidge);
    const std::int64_t yy = std::max<std::int64_t>(m[3] - ((std::int64_t{y_on_x_} * m[1]) >> kRatioBits), 0);
    const std::int64_t yz = around_.means.magnitudes[3] - ((std::int64_t{y_on_x_} * m[2]) >> kRatioBits);
    z_on_y_ = quick_ratio(yz, yy + kRidge);
  }

  /// Expected number given the axes before; 1/16 steps [FLD-4].
  template <unsigned kAxis>
  [[gnu::always_inline]] std::int32_t regress() const noexcept {
    if constexpr (kAxis == 0) return 0;
    if constexpr (kAxis == 1) return (y_on_x_ * r_[0]) >> 8;
    const std::int32_t y_residual = r_[1] * kFieldUnit - regressions_[1];
    return ((z_on_x_ * r_[0]) >> 8) +
           static_cast<std::int32_t>((std::int64_t{z_on_y_} * y_residual) >> kRatioBits);
  }

  /// Mean size of the axes before, 1/16 steps.
  template <unsigned kAxis>
  [[gnu::always_inline]] std::int32_t coded_magnitude() const noexcept {
    if constexpr (kAxis == 0) return 0;
    if constexpr (kAxis == 1) return std::abs(r_[0]) * kFieldUnit;
    return (std::abs(r_[0]) + std::abs(r_[1])) * (kFieldUnit / 2);
  }

  template <unsigned kAxis>
  [[gnu::always_inline]] std::int32_t expected_scale(std::int32_t coded) const noexcept {
    const std::int32_t own = size_[kAxis];
    if constexpr (kAxis == 0) return ((78 * own + 15 * all_) >> 7) + 1;
    return ((64 * own + 13 * all_ + 12 * coded) >> 7) + 1;
  }

  FieldNeighborhood around_;
  std::array<std::int32_t, 3> size_{};    ///< expected magnitudes
  std::array<std::int32_t, 3> own_{};     ///< spreads, or the same
  std::array<std::int32_t, 3> offset_{};  ///< of the hint
  std::int32_t all_ = 0;                  ///< sum of size_
  std::uint32_t degree5_ = 0;             ///< degree class in coarser steps
  std::int32_t y_on_x_ = 0;
  std::int32_t z_on_x_ = 0;
  std::int32_t z_on_y_ = 0;
  // By axis, 1/16 steps.
  std::array<std::int32_t, 3> r_{};
  std::array<std::int32_t, 3> regressions_{};
  std::array<std::int32_t, 3> expected_{};
  std::array<std::int32_t, 3> scales_{};
  std::array<std::int32_t, 3> errors_{};  ///< 0 where an axis is not coded
};

}  // namespace deltamesh
