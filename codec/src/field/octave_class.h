// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Classes of magnitudes for contexts, by table [FLD-15].
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace deltamesh {

/// Values of a table for all that is below its size.
template <class T, std::size_t kSize, class Value>
constexpr std::array<T, kSize> tabulate(Value value) {
  std::array<T, kSize> table{};
  for (std::uint32_t i = 0; i < kSize; ++i) table[i] = static_cast<T>(value(i));
  return table;
}

/// Four classes per octave of value + 4, from 0 on, 23 at most.
constexpr std::uint32_t octave_class(std::uint32_t value) noexcept {
  const std::uint32_t v = value + 4;
  const auto octave = static_cast<unsigned>(std::bit_width(v)) - 3;
  return std::min(4 * octave + ((v >> octave) & 3), 23U);
}

/// By value. No value is larger: an eighth of each of a field's magnitudes is in the scale, whose unit makes
/// it less than 64.
inline constexpr auto kOctaveClass = tabulate<std::uint8_t, 512>(octave_class);

}  // namespace deltamesh
