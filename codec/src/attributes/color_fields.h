// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What stands before the coded levels of colours [ATTR-45].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "attributes/color_levels.h"
#include "attributes/color_memory.h"

namespace deltamesh {

inline constexpr std::uint8_t kConstantComponent = 255;

/// Where a component comes from.
struct ColorSource {
  std::uint8_t component = 0;  ///< itself: coded; one before it: the same levels; or kConstantComponent
  std::uint16_t level = 0;     ///< of a constant one
};

struct ColorFields {
  unsigned bits = 8;        ///< of levels, 8 or 16
  std::uint16_t bound = 0;  ///< how far a decoded level may be off, below half the highest
  unsigned components = 0;  ///< 1 to 4
  std::array<ColorSource, kColorAxes> sources;

  bool is_coded(std::size_t c) const noexcept { return sources[c].component == c; }
};

/// The coded components by axis: in order, but for the first two, which change places [ATTR-45].
struct ColorAxes {
  std::array<std::uint8_t, kColorAxes> components{};
  unsigned count = 0;
};
inline ColorAxes axes_of(const ColorFields& fields) noexcept {
  ColorAxes axes;
  for (std::size_t c = 0; c < fields.components; ++c)
    if (fields.is_coded(c)) axes.components[axes.count++] = static_cast<std::uint8_t>(c);
  if (axes.count > 1) std::swap(axes.components[0], axes.components[1]);
  return axes;
}

inline ColorShape shape_of(const ColorFields& fields, const ColorAxes& axes) noexcept {
  return {.axes = axes.count, .top = top_color_level(fields.bits), .bound = fields.bound};
}

/// Levels by axis to levels by component.
inline ColorLevels levels_by_component(const ColorFields& fields, const ColorAxes& axes,
                                       const ColorLevels& by_axis) noexcept {
  ColorLevels levels{};
  for (std::size_t a = 0; a < axes.count; ++a) levels[axes.components[a]] = by_axis[a];
  for (std::size_t c = 0; c < fields.components; ++c) {
    const ColorSource& source = fields.sources[c];
    if (source.component == kConstantComponent) {
      levels[c] = source.level;
    } else {
      levels[c] = levels[source.component];
    }
  }
  return levels;
}

}  // namespace deltamesh
