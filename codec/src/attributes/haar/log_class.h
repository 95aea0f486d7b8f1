// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Logarithms in whole numbers, for costs, shares and contexts [HAAR-1].
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <limits>

namespace deltamesh {

/// 2^kBits floor(log2 x) and the `kBits` bits below the leading one of x, which is above 0: nearly 2^kBits
/// times the binary logarithm, at most 0.087 of an octave below it.
template <unsigned kBits, std::unsigned_integral Whole>
constexpr std::uint32_t log_class(Whole x) noexcept {
  constexpr unsigned kDigits = std::numeric_limits<Whole>::digits;
  const auto zeros = static_cast<unsigned>(std::countl_zero(x));
  const auto mantissa =
      static_cast<std::uint32_t>((x << zeros) >> (kDigits - 1 - kBits));  // its leading one adds an octave
  return ((kDigits - 2 - zeros) << kBits) + mantissa;
}

/// The same of a whole number from 1 to 2^53, which a double holds exactly: these are its bits, but for the
/// bias of the exponent.
template <unsigned kBits>
constexpr std::uint32_t log_class(double x) noexcept {
  constexpr std::uint32_t kBias = 1023;
  return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(x) >> (52 - kBits)) - (kBias << kBits);
}

}  // namespace deltamesh
