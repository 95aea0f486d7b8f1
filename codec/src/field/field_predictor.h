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

#include "base/quick_ratio.h"
#include "field/field_context.h"

namespace deltamesh {

inline constexpr std::size_t kFieldModels = 3;
inline constexpr std::array<std::uint32_t, kFieldModels> kFieldContexts = {24 * 6 * 5, 24 * 8 * 3 * 3,
                                                                           24 * 12 * 2 * 3};

/// The forecast for one axis of one vertex.
struct FieldForecast {
  std::int32_t mean = 0;    ///< 1/16 steps
  std::int32_t scale = 1;   ///< expected distance from it, 1/16 steps, 1 or more
  unsigned shift = 0;       ///< low bits outside the symbol [FLD-5]
  std::int32_t sign = 0;    ///< -1 where the mean is below 0 and signs are swapped, else 0
  std::int32_t center = 0;  ///< symbol units taken off
  std::array<std::uint32_t, kFieldModels> contexts{};
  std::uint32_t weight_set = 0;
  std::uint32_t tail_context = 0;
};

inline constexpr std::uint32_t kFieldWeightSets = 18;
inline constexpr std::uint32_t kTailContexts = 4 * 6;

/// Forecasts the three axes of a vertex in turn: forecast<0>(), learn<0>(), forecast<1>() and so on.
class FieldPredictor {
 public:
  /// `around` must outlive the vertex; `hint`: null where there is none.
  void begin(const FieldNeighborhood& around, const FieldHint* hint) noexcept {
    around_ = &around.means;
    degree_ = around.degree_class;
    size_ = own_ = around.means.magnitude;
    offset_ = {};
    if (hint != nullptr) {
      own_ = hint->spread;
      offset_ = hint->offset;
      for (std::size_t a = 0; a < 3; ++a) size_[a] = (4 * size_[a] + 5 * own_[a]) >> 3;
    }
    all_ = (size_[0] + size_[1] + size_[2]) / 3;
  }

  template <unsigned kAxis>
  [[gnu::always_inline]] FieldForecast forecast() noexcept {
    features_ = {regress<kAxis>(), around_->q[kAxis]};
    const auto& weights = weights_[kAxis];
    FieldForecast f;
    f.mean = static_cast<std::int32_t>(
        (std::int64_t{weights[0]} * features_[0] + std::int64_t{weights[1]} * features_[1]) >> 16);
    f.mean += offset_[kAxis];
    const std::int32_t coded = coded_magnitude<kAxis>();
    f.scale = expected_scale<kAxis>(coded);
    f.shift = static_cast<unsigned>(std::bit_width(static_cast<std::uint32_t>(f.scale) | 63)) - 6;
    f.sign = f.mean >> 31;
    const std::int32_t distance = (f.mean ^ f.sign) - f.sign;
    const std::int32_t near = distance >> f.shift;  // symbol units, times kFieldUnit
    f.center = near < 56 ? 0 : near / kFieldUnit;
    set_contexts<kAxis>(f, coded, distance, near);
    return f;
  }

  template <unsigned kAxis>
  void learn(std::int32_t q, const FieldForecast& forecast) noexcept {
    q_[kAxis] = std::clamp(q, -kLargestRemembered, kLargestRemembered);
    // Sign-sign least mean squares with a dead zone [FLD-4].
    constexpr std::int32_t kStep = 64;
    const std::int32_t error = q_[kAxis] * kFieldUnit - forecast.mean;
    const std::int32_t dead = forecast.scale / 2;
    const std::int32_t step = (error > dead ? kStep : 0) - (error < -dead ? kStep : 0);
    for (std::size_t i = kAxis == 0 ? 1 : 0; i < 2; ++i) {
      const std::int32_t small = forecast.scale / 4;
      const std::int32_t direction = (features_[i] > small ? 1 : 0) - (features_[i] < -small ? 1 : 0);
      std::int32_t& w = weights_[kAxis][i];
      w = std::clamp(w + direction * step, -4 * 65536, 4 * 65536);
    }
  }

 private:
  /// Expected number given the axes before, by the neighbours' second moments; 1/16 steps [FLD-4].
  template <unsigned kAxis>
  std::int32_t regress() noexcept {
    constexpr std::int64_t kRidge = 5;
    const auto& m = around_->moments;
    if constexpr (kAxis == 0) return 0;
    if constexpr (kAxis == 1) {
      y_on_x_ = quick_ratio(m[1], m[0] + kRidge);
      z_on_x_ = quick_ratio(m[2], m[0] + kRidge);
      return (y_on_x_ * q_[0]) >> 8;
    }
    // What x leaves unexplained of y, and of its product with z.
    const std::int64_t yy = std::max<std::int64_t>(m[3] - ((std::int64_t{y_on_x_} * m[1]) >> kRatioBits), 0);
    const std::int64_t yz = m[4] - ((std::int64_t{y_on_x_} * m[2]) >> kRatioBits);
    const std::int32_t z_on_y = quick_ratio(yz, yy + kRidge);
    const std::int32_t y_residual = q_[1] * kFieldUnit - ((y_on_x_ * q_[0]) >> 8);
    return ((z_on_x_ * q_[0]) >> 8) +
           static_cast<std::int32_t>((std::int64_t{z_on_y} * y_residual) >> kRatioBits);
  }

  /// Mean size of the axes before, 1/16 steps.
  template <unsigned kAxis>
  std::int32_t coded_magnitude() const noexcept {
    if constexpr (kAxis == 0) return 0;
    if constexpr (kAxis == 1) return std::abs(q_[0]) * kFieldUnit;
    return (std::abs(q_[0]) + std::abs(q_[1])) * (kFieldUnit / 2);
  }

  template <unsigned kAxis>
  std::int32_t expected_scale(std::int32_t coded) const noexcept {
    const std::int32_t own = size_[kAxis];
    if constexpr (kAxis == 0) return ((39 * own + 22 * all_) >> 6) + 1;
    return ((32 * own + 20 * all_ + 6 * coded) >> 6) + 1;
  }

  /// Four classes per octave of `value` + 4, from 0 on.
  static std::uint32_t quarter_octave(std::int32_t value, std::uint32_t largest) noexcept {
    const auto v = static_cast<std::uint32_t>(value) + 4;
    const auto octave = static_cast<std::uint32_t>(std::bit_width(v | 4)) - 3;
    return std::min(4 * octave + ((v >> octave) & 3), largest);
  }

  /// How far the mean is from 0 in terms of the scale: 0 to 5.
  static std::uint32_t sureness(std::int32_t distance, std::int32_t scale) noexcept {
    const std::int32_t ten = 10 * distance;
    const std::int32_t s = scale + 2;
    return (ten >= s ? 1U : 0U) + (ten >= 3 * s ? 1U : 0U) + (ten >= 6 * s ? 1U : 0U) +
           (ten >= 10 * s ? 1U : 0U) + (ten >= 17 * s ? 1U : 0U);
  }

  template <unsigned kAxis>
  void set_contexts(FieldForecast& f, std::int32_t coded, std::int32_t distance,
                    std::int32_t near) const noexcept {
    constexpr std::array<std::uint8_t, 6> kCoarse = {0, 1, 1, 2, 2, 2};
    const std::uint32_t sure = sureness(distance, f.scale);
    const std::uint32_t sure3 = kCoarse[sure];
    const std::uint32_t shifted = f.shift > 0 ? 1 : 0;
    const std::uint32_t scale_class = quarter_octave(f.scale >> f.shift, 19) + 4 * shifted;
    const std::uint32_t degree5 = std::clamp<std::uint32_t>(degree_, 1, 5) - 1;
    const std::uint32_t coded_class = quarter_octave(coded >> f.shift, 23);
    const std::uint32_t own_class = quarter_octave(own_[kAxis] >> f.shift, 23);
    f.contexts = {(scale_class * 6 + sure) * 5 + degree5,
                  ((coded_class * 8 + degree_) * 3 + kAxis) * 3 + sure3,
                  ((own_class * 12 + quarter_octave(near, 23) / 2) * 2 + shifted) * 3 + kAxis};
    f.weight_set = scale_class / 4 * 3 + kAxis;
    f.tail_context = std::min(f.shift, 3U) * 6 + sure;
  }

  const FieldMemory* around_ = nullptr;
  std::uint32_t degree_ = 0;
  std::array<std::int32_t, 3> size_{};      ///< expected magnitudes
  std::array<std::int32_t, 3> own_{};       ///< spreads, or the same
  std::array<std::int32_t, 3> offset_{};    ///< of the hint
  std::int32_t all_ = 0;                    ///< mean of size_
  std::array<std::int32_t, 3> q_{};         ///< clamped, axes coded so far
  std::array<std::int32_t, 2> features_{};  ///< of the current axis: regression, neighbours' mean
  std::int32_t y_on_x_ = 0;
  std::int32_t z_on_x_ = 0;
  std::array<std::array<std::int32_t, 2>, 3> weights_{{{0, 0}, {65536, 0}, {65536, 0}}};
};

}  // namespace deltamesh
