// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Components of colours as levels from 0 to 255 or to 65535, and back [ATTR-46]; and what stands before the
// coded levels [ATTR-45].
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "attributes/colors/memory.h"
#include "attributes/values.h"

namespace deltamesh {

/// Levels have 8 or 16 bits.
constexpr bool color_bits_fit(ComponentType type, unsigned bits) noexcept {
  if (type == ComponentType::kU8) return bits == 8;
  return (type == ComponentType::kU16 || type == ComponentType::kF32) && (bits == 8 || bits == 16);
}

constexpr std::int32_t top_color_level(unsigned bits) noexcept { return (1 << bits) - 1; }

/// The bits of the component with this level [ATTR-46].
inline std::uint32_t color_of_level(ComponentType type, unsigned bits, std::int32_t level) noexcept {
  if (type == ComponentType::kF32)
    return std::bit_cast<std::uint32_t>(
        static_cast<float>(static_cast<double>(level) / top_color_level(bits)));
  const auto value = static_cast<std::uint32_t>(level);
  return type == ComponentType::kU16 && bits == 8 ? 257 * value : value;
}

/// The level nearest to the component with bits `color`; none of floats that are not in [0, 1].
inline std::optional<std::int32_t> nearest_color_level(ComponentType type, unsigned bits,
                                                       std::uint32_t color) noexcept {
  if (type == ComponentType::kF32) {
    const auto number = static_cast<double>(std::bit_cast<float>(color));
    if (!(number >= 0 && number <= 1)) return std::nullopt;
    return static_cast<std::int32_t>(std::floor(number * top_color_level(bits) + 0.5));
  }
  const auto value = static_cast<std::int32_t>(color);
  return type == ComponentType::kU16 && bits == 8 ? (value + 128) / 257 : value;
}

inline constexpr std::uint8_t kConstantComponent = 255;

/// How a component of the decoded colour is obtained.
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
    levels[c] = source.component == kConstantComponent ? source.level : levels[source.component];
  }
  return levels;
}

/// Sets a row of `values`, of `type`, to what the levels by axis stand for.
inline void set_color(AttributeValues& values, std::size_t row, ComponentType type, const ColorFields& fields,
                      const ColorAxes& axes, const ColorLevels& by_axis) noexcept {
  const ColorLevels levels = levels_by_component(fields, axes, by_axis);
  for (std::size_t c = 0; c < fields.components; ++c)
    values.set(row, c, color_of_level(type, fields.bits, levels[c]));
}

}  // namespace deltamesh
