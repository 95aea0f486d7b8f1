// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Signed integers as unsigned ones of small value: 0, -1, 1, -2, ... become 0, 1, 2, 3, ... [CON-4].
#pragma once

#include <cstdint>

namespace deltamesh {

constexpr std::uint32_t zigzag(std::int32_t value) noexcept {
  return (static_cast<std::uint32_t>(value) << 1) ^ static_cast<std::uint32_t>(value >> 31);
}

constexpr std::int32_t unzigzag(std::uint32_t code) noexcept {
  return static_cast<std::int32_t>((code >> 1) ^ (~(code & 1) + 1));
}

constexpr std::uint64_t zigzag(std::int64_t value) noexcept {
  return (static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63);
}

constexpr std::int64_t unzigzag(std::uint64_t code) noexcept {
  return static_cast<std::int64_t>((code >> 1) ^ (~(code & 1) + 1));
}

}  // namespace deltamesh
