// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Numbers of any size by the compact coder: bit length, then bits [CMP-8].
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "entropy/coder/model.h"

namespace deltamesh {

inline constexpr unsigned kLongNumber = 15;  ///< bit lengths from here on share a symbol

/// Adaptive Exp-Golomb: a symbol for the bit length, models for the two bits below the leading one.
struct NumberModel {
  [[gnu::noinline]] NumberModel() noexcept {}  // NOLINT(modernize-use-equals-default)

  static constexpr SymbolModel kFreshLength{{8, 8, 8, 8, 7, 6, 5, 4, 3, 2, 2, 1, 1, 1, 1, 1}};

  SymbolModel length = kFreshLength;
  std::array<BitModel, 33> second;
  std::array<std::array<BitModel, 2>, 33> third;
};

/// Codes the bits of `value` (bit length `length`, 1 to 32) below the leading one; returns the whole.
template <class Coder>
std::uint32_t code_mantissa(Coder& coder, std::uint32_t value, unsigned length, BitModel& second,
                            std::array<BitModel, 2>& third) {
  if (length < 2) return length;
  const auto bit_at = [&](unsigned place) { return (value >> place & 1) != 0; };
  const bool high = coder.bit(bit_at(length - 2), second);
  std::uint32_t result = high ? 3 : 2;
  if (length == 2) return result;
  result = result << 1 | (coder.bit(bit_at(length - 3), third[high ? 1 : 0]) ? 1U : 0U);
  if (length == 3) return result;
  const unsigned rest = length - 3;
  return result << rest | coder.bits(value & ((1U << rest) - 1), rest);
}

/// `Coder` is CompactWriter, or CompactReader, where `value` is ignored. Returns the value.
template <class Coder>
std::uint32_t code_number(Coder& coder, std::uint32_t value, NumberModel& model) {
  auto length = static_cast<unsigned>(std::bit_width(value));
  const unsigned symbol = coder.symbol(std::min(length, kLongNumber), Mixture<1>{{&model.length}});
  if (symbol < kLongNumber) {
    length = symbol;
  } else {
    length = std::min(kLongNumber + coder.bits(length - kLongNumber, 5), 32U);
  }
  if (length == 0) return 0;
  return code_mantissa(coder, value, length, model.second[length], model.third[length]);
}

}  // namespace deltamesh
