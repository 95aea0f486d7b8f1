// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Components of colours as levels from 0 to 255 or to 65535, and back [ATTR-46].
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

#include "deltamesh/mesh.h"

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

}  // namespace deltamesh
