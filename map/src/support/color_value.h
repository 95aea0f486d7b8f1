// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Colours of any type in one unit.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "attributes/colors/fields.h"
#include "attributes/values.h"
#include "deltamesh/mesh.h"

namespace deltamesh {

inline bool is_color(const Attribute& a) noexcept {
  return a.kind == AttributeKind::kColor &&
         (a.type == ComponentType::kU8 || a.type == ComponentType::kU16 || a.type == ComponentType::kF32);
}

inline bool are_colors(const Attribute& a, const Attribute& b) noexcept {
  return is_color(a) && is_color(b) && a.type == b.type && a.components == b.components;
}

/// In 255ths of the range. Precondition: is_color().
inline double color_value(const Attribute& color, std::size_t vertex, std::size_t component) noexcept {
  const std::size_t at = vertex * color.components + component;
  switch (color.type) {
    case ComponentType::kU8:
      return std::to_integer<int>(color.values[at]);
    case ComponentType::kU16: {
      std::uint16_t value = 0;
      std::memcpy(&value, color.values.data() + 2 * at, sizeof value);
      return value / 257.0;
    }
    default: {
      float value = 0;
      std::memcpy(&value, color.values.data() + 4 * at, sizeof value);
      return 255.0 * value;
    }
  }
}

/// The nearest level of 8 bits of the component at `from`; 0 of floats that are not in [0, 1].
inline std::uint8_t color_level(ComponentType type, const std::byte* from) noexcept {
  const auto bits = static_cast<std::uint32_t>(load_component(from, component_size(type)));
  return static_cast<std::uint8_t>(nearest_color_level(type, 8, bits).value_or(0));
}

/// The largest difference of a component, 255ths. Precondition: are_colors().
inline double color_difference(const Attribute& a, std::size_t vertex_a, const Attribute& b,
                               std::size_t vertex_b) noexcept {
  double most = 0;
  for (std::size_t c = 0; c < a.components; ++c)
    most = std::max(most, std::abs(color_value(a, vertex_a, c) - color_value(b, vertex_b, c)));
  return most;
}

/// The sum of the squared errors of red, green and blue over all colours of a vertex, 255ths. Attributes that
/// are colours in one mesh are in the other.
inline double squared_color_error(const Mesh& a, std::size_t vertex_a, const Mesh& b,
                                  std::size_t vertex_b) noexcept {
  double sum = 0;
  for (std::size_t i = 0; i < a.attributes.size(); ++i) {
    if (!is_color(a.attributes[i])) continue;
    for (std::size_t c = 0; c < std::min<std::size_t>(a.attributes[i].components, 3); ++c) {
      const double error =
          color_value(a.attributes[i], vertex_a, c) - color_value(b.attributes[i], vertex_b, c);
      sum += error * error;
    }
  }
  return sum;
}

/// How many values squared_color_error() adds up.
inline std::size_t count_color_values(const Mesh& mesh) noexcept {
  std::size_t count = 0;
  for (const Attribute& attribute : mesh.attributes)
    if (is_color(attribute)) count += std::min<std::size_t>(attribute.components, 3);
  return count;
}

/// The root mean square, 255ths; 0 without colours. `order`: the source's vertex for each of `decoded`.
inline double color_rms(const Mesh& source, const Mesh& decoded,
                        std::span<const std::uint32_t> order) noexcept {
  double sum = 0;
  for (std::size_t v = 0; v < order.size(); ++v) sum += squared_color_error(source, order[v], decoded, v);
  const std::size_t count = count_color_values(source) * order.size();
  return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0;
}

}  // namespace deltamesh
