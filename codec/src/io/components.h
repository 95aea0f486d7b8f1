// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Single numbers of an attribute, by component type, in native byte order: little-endian (base/machine.h).
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

#include "base/component.h"
#include "base/machine.h"
#include "deltamesh/mesh.h"

namespace deltamesh {

/// The nearest float; an infinity beyond its range (where a plain conversion would be undefined).
inline float to_float(double value) noexcept {
  if (std::fabs(value) > static_cast<double>(std::numeric_limits<float>::max()))
    return value > 0 ? std::numeric_limits<float>::infinity() : -std::numeric_limits<float>::infinity();
  return static_cast<float>(value);
}

/// The number at `from` as load_component() tells it, integers of a normalized attribute scaled to [0, 1] or
/// [-1, 1] as in glTF.
inline double load_normalized(ComponentType type, bool normalized, const std::byte* from) noexcept {
  return with_component(type, [=](auto value) {
    using T = decltype(value);
    std::memcpy(&value, from, sizeof value);
    const auto real = static_cast<double>(value);
    if constexpr (std::is_integral_v<T>) {
      if (normalized) return std::fmax(real / static_cast<double>(std::numeric_limits<T>::max()), -1.0);
    }
    return real;
  });
}

/// Stores `value` at `to`, native byte order; fractions are cut off for integers. False, and nothing stored,
/// where an integer type cannot hold the value (NaN included).
inline bool store_component(ComponentType type, double value, std::byte* to) noexcept {
  return with_component(type, [=](auto stored) {
    using T = decltype(stored);
    if constexpr (std::is_integral_v<T>) {
      if (!(value > static_cast<double>(std::numeric_limits<T>::min()) - 1.0 &&
            value < static_cast<double>(std::numeric_limits<T>::max()) + 1.0))
        return false;
      stored = static_cast<T>(value);
    } else if constexpr (std::is_same_v<T, float>) {
      stored = to_float(value);
    } else {
      stored = value;
    }
    std::memcpy(to, &stored, sizeof stored);
    return true;
  });
}

/// An attribute with room for `vertices` values, all bits zero.
inline Attribute make_attribute(AttributeKind kind, ComponentType type, std::uint8_t components,
                                std::string name, std::uint64_t vertices) {
  const bool integer = type != ComponentType::kF32 && type != ComponentType::kF64;
  Attribute attribute{.kind = kind,
                      .type = type,
                      .components = components,
                      .normalized = kind == AttributeKind::kColor && integer,
                      .name = std::move(name),
                      .values = {}};
  attribute.values.resize(static_cast<std::size_t>(vertices) * components * component_size(type));
  return attribute;
}

}  // namespace deltamesh
