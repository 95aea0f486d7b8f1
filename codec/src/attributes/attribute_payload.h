// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The fields before the symbols of an ATTR payload [ATTR-1, ATTR-2], and the rules that join shape and
// coding.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "deltamesh/mesh.h"

namespace deltamesh {

/// How the values became symbols [ATTR-2].
enum class AttributeCoding : std::uint8_t {
  kExact = 0,        ///< the bits of every component [ATTR-4]
  kOctahedral = 1,   ///< normals [ATTR-5]
  kColorLevels = 2,  ///< colours, levels over the full range [ATTR-6]
  kUvLevels = 3,     ///< texture coordinates, levels over their own range [ATTR-7]
};

inline constexpr unsigned kMaxComponents = 16;
inline constexpr std::size_t kMaxAttributeName = 255;

/// True where values of this shape may be coded so [ATTR-2].
constexpr bool coding_fits(AttributeCoding coding, AttributeKind kind, ComponentType type,
                           unsigned components) noexcept {
  switch (coding) {
    case AttributeCoding::kExact:
      return true;
    case AttributeCoding::kOctahedral:
      return kind == AttributeKind::kNormal && type == ComponentType::kF32 && components == 3;
    case AttributeCoding::kColorLevels:
      return kind == AttributeKind::kColor && (components == 3 || components == 4) &&
             (type == ComponentType::kU8 || type == ComponentType::kU16 || type == ComponentType::kF32);
    case AttributeCoding::kUvLevels:
      return kind == AttributeKind::kUv && type == ComponentType::kF32 && components == 2;
  }
  return false;
}

/// Most bits a colour of this type is coded with.
constexpr int max_color_bits(ComponentType type) noexcept { return type == ComponentType::kU8 ? 8 : 16; }

/// The bits of the component at `bytes`, zero-extended. `size`: 1, 2, 4 or 8; native byte order.
inline std::uint64_t load_component(const std::byte* bytes, std::size_t size) noexcept {
  std::uint64_t value = 0;
  const std::size_t skip = std::endian::native == std::endian::little ? 0 : sizeof value - size;
  std::memcpy(reinterpret_cast<std::byte*>(&value) + skip, bytes, size);
  return value;
}

inline void store_component(std::byte* bytes, std::size_t size, std::uint64_t value) noexcept {
  const std::size_t skip = std::endian::native == std::endian::little ? 0 : sizeof value - size;
  std::memcpy(bytes, reinterpret_cast<const std::byte*>(&value) + skip, size);
}

}  // namespace deltamesh
