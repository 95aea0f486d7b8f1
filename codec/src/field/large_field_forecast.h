// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What is expected of the three numbers of a vertex of a large field, in turn [FLD-11, FLD-12]. Integers
// only; shared by writer and reader. Written without branches on the data.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "base/floor_log2.h"
#include "field/field_classes.h"
#include "field/large_field_walk.h"

namespace deltamesh {

inline constexpr std::size_t kLargeFieldModels = std::size_t{8} * 2 * 3 * 20 * 4 * 4;
inline constexpr std::size_t kLargeFieldTails = std::size_t{4} * 4;

/// How one number is coded.
struct LargeFieldForecast {
  std::int32_t base = 0;  ///< what is subtracted
  std::int32_t sign = 0;  ///< -1 where signs are swapped, else 0
  unsigned shift = 0;     ///< low bits outside the symbol
  std::size_t model = 0;
  std::size_t tail = 0;
};

/// forecast<0>(), settle<0>(), forecast<1>() and so on.
class LargeFieldVertex {
 public:
  [[gnu::always_inline]] LargeFieldVertex(const LargeFieldWalk& walk, std::uint32_t vertex) noexcept
      : around_(walk.around(vertex)) {
    const EightShorts& sizes = around_.means.numbers_and_sizes;
    const EightShorts& errors = around_.means.ties_and_errors;
    const FourInts is_close = sum_of_upper(errors, 8, sizes, -5) < 0;
    const auto if_close = reinterpret_cast<EightShorts>(is_close);
    scales_ = to_array(choose_lanes(if_close, errors, sizes));
    bases_ = to_array(around_.reference & if_close);
    ties_ = to_array(errors & ~if_close);
    all_ = scale_of(0) + scale_of(1) + scale_of(2);
    sure_ = static_cast<std::uint32_t>(is_close[0]) & 3;
    first_model_ = ((std::clamp<std::uint32_t>(around_.degree, 3, 10) - 3) * 2 + around_.has_peers) * 3;
  }

  const LargeFieldSurroundings& around() const noexcept { return around_; }
  /// The numbers settled.
  const std::array<std::int32_t, 3>& numbers() const noexcept { return q_; }

  template <unsigned kAxis>
  [[gnu::always_inline]] LargeFieldForecast forecast() const noexcept {
    const std::uint32_t own = scale_of(kAxis);
    const std::uint32_t scale = (5 * own + all_) >> 3;
    LargeFieldForecast f;
    f.base = bases_[kAxis];
    f.shift = floor_log2(scale | 63) - 5;
    const std::int32_t expected = expected_tie<kAxis>();
    f.sign = expected >> 31;
    const auto distance = 16 * static_cast<std::uint32_t>(std::abs(expected));
    const std::uint32_t sure = sure_ | ((distance > scale ? 1U : 0U) + (2 * distance > 5 * scale ? 1U : 0U));
    const std::uint32_t coded = coded_size<kAxis>() >> f.shift;
    const std::uint32_t coded_class = kCodedClass[std::min<std::uint32_t>(coded, kCodedClass.size() - 1)];
    const std::uint32_t own_class = kOctaveClass[own >> f.shift];
    f.model = ((first_model_ + kAxis) * 20 + own_class) * 16 + sure * 4 + coded_class;
    f.tail = std::min(f.shift, 3U) * 4 + sure;
    return f;
  }

  template <unsigned kAxis>
  [[gnu::always_inline]] void settle(std::int32_t q) noexcept {
    q_[kAxis] = q;
  }

 private:
  static std::array<std::int16_t, 8> to_array(EightShorts lanes) noexcept {
    return std::bit_cast<std::array<std::int16_t, 8>>(lanes);
  }

  /// By size of what was coded of the axes before.
  static constexpr auto kCodedClass = tabulate<std::uint8_t, 93>(
      [](std::uint32_t i) { return (i >= 8 ? 1 : 0) + (i >= 28 ? 1 : 0) + (i >= 92 ? 1 : 0); });

  std::uint32_t scale_of(unsigned axis) const noexcept {
    return static_cast<std::uint16_t>(scales_[4 + axis]);
  }
  static std::int32_t sign_of(std::int32_t q) noexcept { return (q > 0 ? 1 : 0) - (q < 0 ? 1 : 0); }

  /// From the axes before; 1/4 steps.
  template <unsigned kAxis>
  [[gnu::always_inline]] std::int32_t expected_tie() const noexcept {
    if constexpr (kAxis == 0) return 0;
    if constexpr (kAxis == 1) return sign_of(q_[0]) * ties_[0];
    return sign_of(q_[0]) * ties_[1] + sign_of(q_[1]) * ties_[2];
  }

  /// Mean size of what was coded of the axes before, 1/16 steps, modulo 2^32.
  template <unsigned kAxis>
  [[gnu::always_inline]] std::uint32_t coded_size() const noexcept {
    const auto size = [&](std::size_t axis) {
      return static_cast<std::uint32_t>(std::abs(q_[axis] - bases_[axis]));
    };
    if constexpr (kAxis == 0) return 0;
    if constexpr (kAxis == 1) return 16 * size(0);
    return 8 * (size(0) + size(1));
  }

  LargeFieldSurroundings around_;
  std::array<std::int16_t, 8> scales_;  ///< from lane 4 on: expected sizes of what is coded, 1/16 steps
  std::array<std::int16_t, 8> bases_;
  std::array<std::int16_t, 8> ties_;
  std::uint32_t all_ = 0;   ///< sum of these sizes
  std::uint32_t sure_ = 0;  ///< 3 where numbers are coded as differences to the reference
  std::uint32_t first_model_ = 0;
  std::array<std::int32_t, 3> q_{};
};

}  // namespace deltamesh
