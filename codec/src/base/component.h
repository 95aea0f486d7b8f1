// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From a component type to the C++ type that it stands for, and its numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include "deltamesh/mesh.h"

namespace deltamesh {

/// Calls `f` with a value of the C++ type that `type` stands for.
template <class F>
decltype(auto) with_component(ComponentType type, F&& f) {
  switch (type) {
    case ComponentType::kI8:
      return f(std::int8_t{});
    case ComponentType::kU8:
      return f(std::uint8_t{});
    case ComponentType::kI16:
      return f(std::int16_t{});
    case ComponentType::kU16:
      return f(std::uint16_t{});
    case ComponentType::kI32:
      return f(std::int32_t{});
    case ComponentType::kU32:
      return f(std::uint32_t{});
    case ComponentType::kF32:
      return f(float{});
    case ComponentType::kF64:
      break;
  }
  return f(double{});
}

/// The number at `from`, native byte order; exact.
inline double load_component(ComponentType type, const std::byte* from) noexcept {
  return with_component(type, [from](auto value) {
    std::memcpy(&value, from, sizeof value);
    return static_cast<double>(value);
  });
}

/// The value that stands for 1 in normalised attributes: the largest value of an integer type, 1 for floats.
inline double normalized_one(ComponentType type) noexcept {
  return with_component(type, [](auto value) {
    using T = decltype(value);
    return std::is_integral_v<T> ? static_cast<double>(std::numeric_limits<T>::max()) : 1.0;
  });
}

}  // namespace deltamesh
