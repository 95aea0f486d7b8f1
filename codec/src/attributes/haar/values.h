// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Decoded records to the values of an attribute.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "attributes/colors/fields.h"
#include "attributes/haar/color_axes.h"
#include "attributes/haar/fields.h"
#include "attributes/haar/surroundings.h"
#include "attributes/values.h"
#include "base/memory/large_vector.h"

namespace deltamesh {

class HaarValues {
 public:
  /// `components`: 1, 3 or 4, of u8, u16 or f32.
  HaarValues(ComponentType type, unsigned components, std::uint32_t rows)
      : type_(type), rows_(rows), values_(type, components, rows) {}

  /// `records`: of all rows. `axes`: 1 or 3 [HAAR-14].
  void set_colors(const LargeVector<HaarRecord>& records, unsigned axes) noexcept {
    for (std::uint32_t v = 0; v < records.size(); ++v) {
      const Rgb rgb = rgb_of({records[v].value(0), records[v].value(1), records[v].value(2)}, axes);
      for (std::size_t c = 0; c < kHaarAxes; ++c) set(v, c, rgb[c]);
    }
  }

  /// `records`: of all rows, of one component [HAAR-15].
  void set_numbers(const LargeVector<HaarRecord>& records, const HaarScale& scale) noexcept {
    constexpr double kPart = 1.0 / (1 << kHaarUnitBits);
    for (std::uint32_t v = 0; v < records.size(); ++v)
      values_.set(v, 0, bits_of(double{scale.low} + double{scale.unit} * records[v].value(0) * kPart));
  }

  void set_alpha(std::uint8_t level) noexcept {
    for (std::uint32_t v = 0; v < rows_; ++v) set(v, kHaarAxes, level);
  }
  void set_alpha(const LargeVector<HaarRecord>& records) noexcept {
    for (std::uint32_t v = 0; v < records.size(); ++v)
      set(v, kHaarAxes, rgb_of({records[v].value(0), 0, 0}, 1)[0]);
  }

  std::vector<std::byte> take() noexcept { return values_.take(); }

 private:
  /// The nearest value of the type.
  std::uint32_t bits_of(double number) const noexcept {
    if (type_ == ComponentType::kF32) return std::bit_cast<std::uint32_t>(static_cast<float>(number));
    const double most = type_ == ComponentType::kU8 ? std::numeric_limits<std::uint8_t>::max()
                                                    : std::numeric_limits<std::uint16_t>::max();
    return static_cast<std::uint32_t>(std::clamp(std::floor(number + 0.5), 0.0, most));
  }
  void set(std::uint32_t v, std::size_t component, std::uint8_t level) noexcept {
    values_.set(v, component, color_of_level(type_, 8, level));
  }

  ComponentType type_;
  std::uint32_t rows_;
  AttributeValues values_;
};

}  // namespace deltamesh
