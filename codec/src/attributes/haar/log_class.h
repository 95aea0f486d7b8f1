// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Logarithms in whole numbers, for costs, shares and contexts [HAAR-1].
#pragma once

#include <bit>
#include <cstdint>

namespace deltamesh {

/// 2^kBits floor(log2 x) and the `kBits` bits below the leading one of x, which is above 0: nearly 2^kBits
/// times the binary logarithm, at most 0.087 of an octave below it.
template <unsigned kBits>
constexpr std::uint32_t log_class(std::uint64_t x) noexcept {
  const auto zeros = static_cast<unsigned>(std::countl_zero(x));
  const auto mantissa =
      static_cast<std::uint32_t>((x << zeros) >> (63 - kBits));  // its leading one adds an octave
  return ((62 - zeros) << kBits) + mantissa;
}

}  // namespace deltamesh
