// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What is expected of the three numbers of a vertex of a large field, in turn [FLD-11, FLD-12]. Integers
// only; shared by writer and reader. Written without branches on the data.
#pragma once

#include <algorithm>
#include <array>
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
    const std::int32_t size = sizes[4] + sizes[5] + sizes[6];
    const std::int32_t error = errors[4] + errors[5] + errors[6];
    is_close_ = 8 * error < 5 * size;
    all_ = is_close_ ? error : size;
    const EightShorts if_close = all_lanes(is_close_ ? -1 : 0);
    scales_ = (errors & if_close) | (sizes & ~if_close);
    bases_ = around_.reference & if_close;
    first_model_ = (around_.degree_class * 2 + around_.has_peers) * 3;
  }

  const LargeFieldSurroundings& around() const noexcept { return around_; }
  /// The numbers settled, cut to kLargeFieldCut.
  const std::array<std::int32_t, 3>& numbers() const noexcept { return r_; }

  template <unsigned kAxis>
  [[gnu::always_inline]] LargeFieldForecast forecast() const noexcept {
    const std::int32_t own = scales_[4 + kAxis];
    const std::int32_t scale = ((5 * own + all_) >> 3) + 1;
    LargeFieldForecast f;
    f.base = bases_[kAxis];
    f.shift = floor_log2(static_cast<std::uint32_t>(scale) | 63) - 5;
    const std::int32_t expected = expected_tie<kAxis>();
    f.sign = is_close_ ? 0 : expected >> 31;
    const std::int32_t distance = 16 * std::abs(expected);
    const std::size_t sure = is_close_ ? 3 : (distance > scale ? 1 : 0) + (2 * distance > 5 * scale ? 1 : 0);
    const std::int32_t coded = coded_size<kAxis>() >> f.shift;
    const std::size_t coded_class = (coded >= 8 ? 1 : 0) + (coded >= 28 ? 1 : 0) + (coded >= 92 ? 1 : 0);
    const std::size_t own_class = kOctaveClass[static_cast<std::uint32_t>(own) >> f.shift];
    f.model = (((first_model_ + kAxis) * 20 + own_class) * 4 + sure) * 4 + coded_class;
    f.tail = std::min(f.shift, 3U) * 4 + sure;
    return f;
  }

  template <unsigned kAxis>
  [[gnu::always_inline]] void settle(std::int32_t q) noexcept {
    r_[kAxis] = std::clamp(q, -kLargeFieldCut, kLargeFieldCut);
  }

 private:
  static std::int32_t with_sign_of(std::int32_t r, std::int32_t tie) noexcept {
    return r > 0 ? tie : r < 0 ? -tie : 0;
  }

  /// From the axes before; 1/4 steps.
  template <unsigned kAxis>
  [[gnu::always_inline]] std::int32_t expected_tie() const noexcept {
    const EightShorts& ties = around_.means.ties_and_errors;
    if constexpr (kAxis == 0) return 0;
    if constexpr (kAxis == 1) return with_sign_of(r_[0], ties[0]);
    return with_sign_of(r_[0], ties[1]) + with_sign_of(r_[1], ties[2]);
  }

  /// Mean size of what was coded of the axes before, 1/16 steps.
  template <unsigned kAxis>
  [[gnu::always_inline]] std::int32_t coded_size() const noexcept {
    const auto size = [&](std::size_t axis) { return std::abs(r_[axis] - bases_[static_cast<int>(axis)]); };
    if constexpr (kAxis == 0) return 0;
    if constexpr (kAxis == 1) return 16 * size(0);
    return 8 * (size(0) + size(1));
  }

  LargeFieldSurroundings around_;
  EightShorts scales_;  ///< from lane 4 on: expected sizes of what is coded, 1/16 steps
  EightShorts bases_;
  std::int32_t all_ = 0;  ///< sum of these sizes
  bool is_close_ = false;
  std::size_t first_model_ = 0;
  std::array<std::int32_t, 3> r_{};
};

}  // namespace deltamesh
