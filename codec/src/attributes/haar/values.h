// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Decoded records to the values of an attribute.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "attributes/colors/fields.h"
#include "attributes/haar/color_axes.h"
#include "attributes/haar/surroundings.h"
#include "attributes/values.h"
#include "base/memory/large_vector.h"

namespace deltamesh {

class HaarValues {
 public:
  /// `components`: 3 or 4, of u8, u16 or f32.
  HaarValues(ComponentType type, unsigned components, std::uint32_t rows)
      : type_(type), rows_(rows), values_(type, components, rows) {}

  /// `records`: of all rows. `axes`: 1 or 3 [HAAR-14].
  void set_colors(const LargeVector<HaarRecord>& records, unsigned axes) noexcept {
    for (std::uint32_t v = 0; v < records.size(); ++v) {
      const Rgb rgb = rgb_of({records[v].value(0), records[v].value(1), records[v].value(2)}, axes);
      for (std::size_t c = 0; c < kHaarAxes; ++c) set(v, c, rgb[c]);
    }
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
  void set(std::uint32_t v, std::size_t component, std::uint8_t level) noexcept {
    values_.set(v, component, color_of_level(type_, 8, level));
  }

  ComponentType type_;
  std::uint32_t rows_;
  AttributeValues values_;
};

}  // namespace deltamesh
