// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Eight 16-bit numbers handled at once: enough for classes and indices, and twice as many as of 32 bits.
#pragma once

#include <algorithm>
#include <cstdint>

#include "base/four_ints.h"

namespace deltamesh {

using EightShorts = std::int16_t __attribute__((vector_size(16)));

constexpr EightShorts all_lanes(std::int32_t number) noexcept {
  const auto lane = static_cast<std::int16_t>(number);
  return EightShorts{lane, lane, lane, lane, lane, lane, lane, lane};
}

/// Lanes of `low`, then of `high`, each at least -2^15 and at most 2^15 - 1.
inline EightShorts pack_lanes(FourInts low, FourInts high) noexcept {
#if defined(__SSE2__)
  return reinterpret_cast<EightShorts>(
      _mm_packs_epi32(reinterpret_cast<__m128i>(low), reinterpret_cast<__m128i>(high)));
#else
  EightShorts result;
  for (int i = 0; i < 8; ++i)
    result[i] = static_cast<std::int16_t>(std::clamp(i < 4 ? low[i] : high[i - 4], -0x8000, 0x7fff));
  return result;
#endif
}

/// The first four lanes, twice.
inline EightShorts twice_low(EightShorts lanes) noexcept {
  return __builtin_shufflevector(lanes, lanes, 0, 1, 2, 3, 0, 1, 2, 3);
}

/// The upper four lanes of `high` after the first four of `low`.
inline EightShorts join_halves(EightShorts low, EightShorts high) noexcept {
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 12, 13, 14, 15);
}

/// Where a lane of `mask` is -1 that of `if_set`, where it is 0 that of `if_clear`.
inline EightShorts choose_lanes(EightShorts mask, EightShorts if_set, EightShorts if_clear) noexcept {
  return (if_set & mask) | (if_clear & ~mask);
}

/// Modulo 2^16.
inline EightShorts wrapped_sum(EightShorts a, EightShorts b) noexcept {
  using EightUnsigned = std::uint16_t __attribute__((vector_size(16)));
  return reinterpret_cast<EightShorts>(reinterpret_cast<EightUnsigned>(a) +
                                       reinterpret_cast<EightUnsigned>(b));
}
inline EightShorts wrapped_difference(EightShorts a, EightShorts b) noexcept {
  using EightUnsigned = std::uint16_t __attribute__((vector_size(16)));
  return reinterpret_cast<EightShorts>(reinterpret_cast<EightUnsigned>(a) -
                                       reinterpret_cast<EightUnsigned>(b));
}

/// (a * b) >> 16.
inline EightShorts multiply_high(EightShorts a, EightShorts b) noexcept {
#if defined(__SSE2__)
  return reinterpret_cast<EightShorts>(
      _mm_mulhi_epi16(reinterpret_cast<__m128i>(a), reinterpret_cast<__m128i>(b)));
#else
  EightShorts result;
  for (int i = 0; i < 8; ++i) result[i] = static_cast<std::int16_t>((a[i] * b[i]) >> 16);
  return result;
#endif
}

/// The same of lanes that stand for 0 to 65535.
inline EightShorts multiply_high_unsigned(EightShorts a, EightShorts b) noexcept {
#if defined(__SSE2__)
  return reinterpret_cast<EightShorts>(
      _mm_mulhi_epu16(reinterpret_cast<__m128i>(a), reinterpret_cast<__m128i>(b)));
#else
  const auto number = [](std::int16_t lane) { return std::uint32_t{static_cast<std::uint16_t>(lane)}; };
  EightShorts result;
  for (int i = 0; i < 8; ++i) result[i] = static_cast<std::int16_t>((number(a[i]) * number(b[i])) >> 16);
  return result;
#endif
}

/// What the last four lanes of `a`, each times `a_weight`, and of `b`, each times `b_weight`, add up to, in
/// every lane.
inline FourInts sum_of_upper(EightShorts a, std::int32_t a_weight, EightShorts b,
                             std::int32_t b_weight) noexcept {
#if defined(__SSE2__)
  const __m128i pairs = _mm_unpackhi_epi16(reinterpret_cast<__m128i>(a), reinterpret_cast<__m128i>(b));
  const auto weights = _mm_set1_epi32((a_weight & 0xffff) | b_weight * 0x10000);
  const auto products = reinterpret_cast<FourInts>(_mm_madd_epi16(pairs, weights));
  const FourInts halves = products + __builtin_shufflevector(products, products, 2, 3, 0, 1);
  return halves + __builtin_shufflevector(halves, halves, 1, 0, 3, 2);
#else
  std::int32_t sum = 0;
  for (int i = 4; i < 8; ++i) sum += a[i] * a_weight + b[i] * b_weight;
  return FourInts{sum, sum, sum, sum};
#endif
}

/// (a + b + 1) >> 1, no lane below 0.
inline EightShorts rounded_means(EightShorts a, EightShorts b) noexcept {
#if defined(__SSE2__)
  return reinterpret_cast<EightShorts>(
      _mm_avg_epu16(reinterpret_cast<__m128i>(a), reinterpret_cast<__m128i>(b)));
#else
  EightShorts result;
  for (int i = 0; i < 8; ++i) result[i] = static_cast<std::int16_t>((a[i] + b[i] + 1) >> 1);
  return result;
#endif
}

/// Absolute values, of lanes above -2^15.
inline EightShorts lane_sizes(EightShorts lanes) noexcept {
  const EightShorts opposite = -lanes;
  return lanes > opposite ? lanes : opposite;
}

inline EightShorts larger_lanes(EightShorts a, EightShorts b) noexcept { return a > b ? a : b; }
inline EightShorts smaller_lanes(EightShorts a, EightShorts b) noexcept { return a < b ? a : b; }

}  // namespace deltamesh
