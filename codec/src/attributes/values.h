// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Values of an attribute as bytes: n x components, in native byte order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/memory/large_vector.h"
#include "deltamesh/mesh.h"

namespace deltamesh {

/// Calls `copy` with `size`, 1, 2, 4 or 8, as a constant: compilers make a call of a copy of any size.
template <class Copy>
void with_fixed_size(std::size_t size, Copy copy) noexcept {
  switch (size) {
    case 1:
      return copy(std::integral_constant<std::size_t, 1>{});
    case 2:
      return copy(std::integral_constant<std::size_t, 2>{});
    case 4:
      return copy(std::integral_constant<std::size_t, 4>{});
    default:
      return copy(std::integral_constant<std::size_t, 8>{});
  }
}

/// The bits of the component at `bytes`, zero-extended. `size`: 1, 2, 4 or 8; little-endian, as machines are
/// (base/machine.h).
inline std::uint64_t load_component(const std::byte* bytes, std::size_t size) noexcept {
  std::uint64_t value = 0;
  with_fixed_size(size, [&](auto fixed) { std::memcpy(&value, bytes, fixed); });
  return value;
}

inline void store_component(std::byte* bytes, std::size_t size, std::uint64_t value) noexcept {
  with_fixed_size(size, [&](auto fixed) { std::memcpy(bytes, &value, fixed); });
}

/// Decoded values, all bits of which are 0 until they are set.
class AttributeValues {
 public:
  AttributeValues(ComponentType type, std::size_t components, std::size_t rows)
      : size_(component_size(type)), components_(components), rows_(rows) {
    reserve_large(values_, rows * components * size_);
    values_.resize(rows * components * size_);
  }

  void set(std::size_t row, std::size_t component, std::uint64_t bits) noexcept {
    store_component(values_.data() + (row * components_ + component) * size_, size_, bits);
  }
  /// Sets the component of every row to `bits_of(row)`.
  template <class BitsOf>
  void set_component(std::size_t component, BitsOf bits_of) noexcept {
    if (rows_ == 0) return;  // there is no memory to point into
    std::byte* place = values_.data() + component * size_;
    for (std::size_t row = 0; row < rows_; ++row, place += components_ * size_)
      store_component(place, size_, bits_of(row));
  }

  std::vector<std::byte> take() noexcept { return std::move(values_); }

 private:
  std::size_t size_;
  std::size_t components_;
  std::size_t rows_;
  std::vector<std::byte> values_;
};

/// An attribute's values as written in the coding of its kind.
template <class T>
struct CodedValues {
  std::vector<std::byte> bytes;  ///< what follows the byte of the coding [ATTR-2]
  std::vector<T> values;         ///< of all vertices, as decoders get them
};

}  // namespace deltamesh
