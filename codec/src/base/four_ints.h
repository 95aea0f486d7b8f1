// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Four 32-bit numbers handled at once.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "base/four_floats.h"
#include "base/mean.h"
#include "base/two_doubles.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace deltamesh {

using FourInts = std::int32_t __attribute__((vector_size(16)));
using FourUnsigned = std::uint32_t __attribute__((vector_size(16)));

inline FourInts four_ints(const std::array<std::uint32_t, 4>& numbers) noexcept {
  return std::bit_cast<FourInts>(numbers);
}

/// Three numbers and a 0.
inline FourInts four_ints(const std::array<std::int32_t, 3>& numbers) noexcept {
#if defined(__SSE2__)
  return reinterpret_cast<FourInts>(_mm_unpacklo_epi64(
      _mm_loadl_epi64(reinterpret_cast<const __m128i*>(numbers.data())), _mm_cvtsi32_si128(numbers[2])));
#else
  return FourInts{numbers[0], numbers[1], numbers[2], 0};
#endif
}

/// All but the last, in pieces that four_ints() soon after finds as they were written.
inline void store_three(FourInts lanes, std::array<std::int32_t, 3>& numbers) noexcept {
#if defined(__SSE2__)
  _mm_storel_epi64(reinterpret_cast<__m128i*>(numbers.data()), reinterpret_cast<__m128i>(lanes));
#else
  numbers[0] = lanes[0];
  numbers[1] = lanes[1];
#endif
  numbers[2] = lanes[2];
}

/// A bit for every lane that is below 0.
inline unsigned set_lanes(FourInts lanes) noexcept {
#if defined(__SSE2__)
  return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(lanes)));
#else
  unsigned set = 0;
  for (unsigned i = 0; i < 4; ++i) set |= lanes[i] < 0 ? 1U << i : 0U;
  return set;
#endif
}

/// About every lane / count, rounded down: (lane * kOneOver[count]) >> 16. Lanes are below 2^30 + 2^28 in
/// size.
inline FourInts mean_lanes(FourInts lanes, unsigned count) noexcept {
  // With the bias added, products of unsigned numbers do.
  constexpr std::uint32_t kBias = 5U << 28;
  const auto one_over = static_cast<std::int32_t>(kOneOver[count]);
  const FourUnsigned sums = reinterpret_cast<FourUnsigned>(lanes) + kBias;
#if defined(__SSE2__)
  const auto biased = reinterpret_cast<__m128i>(sums);
  const __m128i factor = _mm_set1_epi32(one_over);
  const __m128i even = _mm_srli_epi64(_mm_mul_epu32(biased, factor), 16);
  const __m128i odd = _mm_slli_epi64(_mm_mul_epu32(_mm_srli_epi64(biased, 32), factor), 16);
  const __m128i high_halves = _mm_set_epi32(-1, 0, -1, 0);
  const auto means = reinterpret_cast<FourInts>(
      _mm_or_si128(_mm_andnot_si128(high_halves, even), _mm_and_si128(high_halves, odd)));
#else
  FourInts means;
  for (int i = 0; i < 4; ++i)
    means[i] = static_cast<std::int32_t>(std::uint64_t{sums[i]} * static_cast<std::uint32_t>(one_over) >> 16);
#endif
  return means - static_cast<std::int32_t>(kBias >> 16) * one_over;
}

/// Rounded to the nearest, ties to even.
inline FourFloats to_floats(FourInts lanes) noexcept { return __builtin_convertvector(lanes, FourFloats); }

/// Products of lanes that 16 bits hold.
inline FourInts multiply_short_lanes(FourInts a, FourInts b) noexcept {
#if defined(__SSE2__)
  return reinterpret_cast<FourInts>(
      _mm_madd_epi16(reinterpret_cast<__m128i>(a & 0xffff), reinterpret_cast<__m128i>(b)));
#else
  return a * b;
#endif
}

/// A third of the lanes' sum, rounded down, in every lane. No lane is below 0, the sum is below 2^31.
inline FourInts third_of_sum(FourInts lanes) noexcept {
  const FourInts halves = lanes + __builtin_shufflevector(lanes, lanes, 2, 3, 0, 1);
  const FourInts sum = halves + __builtin_shufflevector(halves, halves, 1, 0, 3, 2);
#if defined(__SSE2__)
  // Exact below 2^31: the factor is 2^32 / 3 and 2 / 3 more.
  const auto thirds =
      reinterpret_cast<FourInts>(_mm_mul_epu32(reinterpret_cast<__m128i>(sum), _mm_set1_epi32(0x55555556)));
  return __builtin_shufflevector(thirds, thirds, 1, 1, 3, 3);
#else
  return FourInts{} + sum[0] / 3;
#endif
}

/// (5 now + 3 before) >> 3: 0.6 of the one and 0.4 of the other, about.
inline FourInts smooth_lanes(FourInts now, FourInts before) noexcept {
  return ((now << 2) + now + (before << 1) + before) >> 3;
}

inline FourInts larger_lanes(FourInts a, FourInts b) noexcept { return a > b ? a : b; }
inline FourInts smaller_lanes(FourInts a, FourInts b) noexcept { return a < b ? a : b; }

/// Every lane between -most and most.
inline FourInts clamp_lanes(FourInts lanes, std::int32_t most) noexcept {
  const FourInts above = lanes > most;
  const FourInts below = lanes < -most;
  return (lanes & ~(above | below)) | (above & most) | (below & -most);
}

/// The nearest whole numbers, of two the even one; -2^31 for what has none of 32 bits.
inline FourInts nearest_lanes(FourFloats lanes) noexcept {
#if defined(__SSE2__)
  return reinterpret_cast<FourInts>(_mm_cvtps_epi32(lanes));
#else
  FourInts nearest;
  for (int i = 0; i < 4; ++i)
    nearest[i] =
        std::abs(lanes[i]) < 0x1p31F ? static_cast<std::int32_t>(std::nearbyint(lanes[i])) : INT32_MIN;
  return nearest;
#endif
}

inline FourInts nearest_lanes(TwoDoubles low, TwoDoubles high) noexcept {
#if defined(__SSE2__)
  return reinterpret_cast<FourInts>(_mm_unpacklo_epi64(_mm_cvtpd_epi32(low), _mm_cvtpd_epi32(high)));
#else
  const auto nearest = [](double v) {
    const double whole = std::nearbyint(v);
    return std::abs(whole) < 0x1p31 ? static_cast<std::int32_t>(whole) : INT32_MIN;
  };
  return FourInts{nearest(low[0]), nearest(low[1]), nearest(high[0]), nearest(high[1])};
#endif
}

/// Absolute values.
inline FourInts lane_sizes(FourInts lanes) noexcept {
  const FourInts sign = lanes >> 31;
  return (lanes ^ sign) - sign;
}

}  // namespace deltamesh
