// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Means of a few numbers without a division [POSN-4].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace deltamesh {

inline constexpr std::size_t kMostMeaned = 16;

/// round(65536 / count)
inline constexpr std::array<std::int64_t, kMostMeaned + 1> kOneOver = [] {
  std::array<std::int64_t, kMostMeaned + 1> table{};
  for (std::size_t n = 1; n < table.size(); ++n) {
    const auto count = static_cast<std::int64_t>(n);
    table[n] = (65536 + count / 2) / count;
  }
  return table;
}();

}  // namespace deltamesh
