// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Colours of any type in one unit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

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

}  // namespace deltamesh
