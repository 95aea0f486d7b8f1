// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Division by table, for contexts and predictions of the compact coder: the same on every machine, and
// several times as fast as the instruction [CMP-9].
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/floor_log2.h"

namespace deltamesh {

inline constexpr unsigned kRatioBits = 12;  ///< fraction bits of a ratio

/// floor(2^25 / t) for t = 512 .. 1023.
inline constexpr std::array<std::uint32_t, 512> kReciprocals = [] {
  std::array<std::uint32_t, 512> table{};
  for (std::uint32_t i = 0; i < 512; ++i) table[i] = (1U << 25) / (512 + i);
  return table;
}();

/// About a / b in parts of 2^12, at most 8 in size; exact up to the ten highest bits of b [CMP-9].
/// `a`: less than 2^40 in size; `b`: 1 to 2^40.
constexpr std::int32_t quick_ratio(std::int64_t a, std::int64_t b) noexcept {
  const auto width = floor_log2(static_cast<std::uint64_t>(b)) + 1;
  const std::uint64_t top = (static_cast<std::uint64_t>(b) << 10) >> width;
  const std::int64_t ratio = (a * kReciprocals[top - 512]) >> (width + 3);
  return static_cast<std::int32_t>(std::clamp<std::int64_t>(ratio, -(8 << kRatioBits), 8 << kRatioBits));
}

}  // namespace deltamesh
