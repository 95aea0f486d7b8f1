// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Single values of attributes as numbers, and how far two of them are apart in the unit of their kind.
#pragma once

#include <cstddef>
#include <cstdint>

#include "deltamesh/mesh.h"

namespace deltamesh {

inline constexpr std::size_t kMaxValueComponents = 16;

/// Bytes of one value.
inline std::size_t value_size(const AttributeView& attribute) noexcept {
  return attribute.components * component_size(attribute.type);
}

/// Value `i` of `a` against value `j` of `b`, which has as many components, in the unit of Comparison:
/// degrees, distance of texture coordinates, 255ths of a colour's range, else the largest difference of a
/// component, where weights of integer types are parts of 1. 0 where all bits are the same, infinity where
/// the difference is not a number. O(1).
double value_error(const AttributeView& a, std::uint32_t i, const AttributeView& b, std::uint32_t j) noexcept;

}  // namespace deltamesh
