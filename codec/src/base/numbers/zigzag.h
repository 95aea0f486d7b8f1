// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Signed integers as unsigned ones of small value: 0, -1, 1, -2, ... become 0, 1, 2, 3, ... [CON-4].
#pragma once

#include <type_traits>

namespace deltamesh {

/// `T`: of 32 or 64 bits.
template <class T>
constexpr std::make_unsigned_t<T> zigzag(T value) noexcept {
  using Code = std::make_unsigned_t<T>;
  return (static_cast<Code>(value) << 1) ^ static_cast<Code>(value >> (8 * sizeof(T) - 1));
}

template <class Code>
constexpr std::make_signed_t<Code> unzigzag(Code code) noexcept {
  return static_cast<std::make_signed_t<Code>>((code >> 1) ^ (~(code & 1) + 1));
}

}  // namespace deltamesh
