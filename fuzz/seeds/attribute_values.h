// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Attributes as meshes have them, for seeds.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "attributes/lattice/component_lattice.h"
#include "attributes/values.h"
#include "deltamesh/mesh.h"
#include "seeds.h"

namespace deltamesh::fuzz {

using enum AttributeKind;
using enum ComponentType;

inline constexpr unsigned kSide = 6;  ///< vertices of a patch

/// Of vertex `v` of a patch, smooth, 0 to 1.
inline double wave(std::uint32_t v, unsigned component) {
  return 0.5 + 0.4 * std::sin(0.5 * (v % kSide) + component) * std::cos(0.3 * (v / kSide));
}

inline std::array<double, 3> direction(std::uint32_t v) {
  const double x = wave(v, 0) - 0.5;
  const double y = wave(v, 1) - 0.5;
  const double length = std::sqrt(x * x + y * y + 1);
  return {x / length, y / length, 1 / length};
}

/// What attributes of the kind are like: integers, shares of 1, vectors of length 1.
inline double value_of(const Attribute& a, std::uint32_t v, unsigned component) {
  const bool is_real = a.type == kF32 || a.type == kF64;
  const double top = is_real ? 1 : a.type == kU8 ? 255 : 65535;
  if (a.kind == kNormal || a.kind == kTangent) return component < 3 ? direction(v)[component] : 1;
  if (a.kind == kJoints) return v / 12 + component;
  if (a.kind == kWeights) {
    // Shares in 255ths, which add up in every type.
    const double first = std::floor(150 * wave(v, 0));
    const double shares[] = {first, 200 - first, 55, 0};
    return shares[component] * top / 255;
  }
  if (a.kind != kColor && a.type == kF32) return wave(v, component);
  // What is coded exactly: colours that are whole 255ths, doubles that are on a lattice.
  const double steps = is_real ? 255 : top;
  return std::floor(steps * wave(v, component)) * top / steps;
}

inline Attribute attribute_of(AttributeKind kind, ComponentType type, unsigned components,
                              std::uint32_t vertices) {
  Attribute a{.kind = kind, .type = type, .components = static_cast<std::uint8_t>(components), .name = "a"};
  AttributeValues values(type, components, vertices);
  for (std::uint32_t v = 0; v < vertices; ++v)
    for (unsigned c = 0; c < components; ++c) values.set(v, c, bits_of_number(type, value_of(a, v, c)));
  a.values = values.take();
  return a;
}

inline Bytes float_bytes(std::span<const float> numbers) {
  const auto bytes = std::as_bytes(numbers);
  return {bytes.begin(), bytes.end()};
}

}  // namespace deltamesh::fuzz
