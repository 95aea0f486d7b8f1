// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Two times four 16-bit numbers handled at once, for spots of two vertices in their voxel cubes: plain and
// for SSE2, with equal results.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "base/eight_shorts.h"

namespace deltamesh {

using FourShorts = std::array<std::int16_t, 4>;

/// Both in memory.
inline std::array<FourShorts, 2> halves_of(EightShorts lanes) noexcept {
  return std::bit_cast<std::array<FourShorts, 2>>(lanes);
}

/// Numbers 1, 2, 0, 3 of each half.
inline EightShorts rotate(EightShorts lanes) noexcept {
  return __builtin_shufflevector(lanes, lanes, 1, 2, 0, 3, 5, 6, 4, 7);
}

/// The last of each half everywhere in it.
inline EightShorts last_of_half(EightShorts lanes) noexcept {
  return __builtin_shufflevector(lanes, lanes, 3, 3, 3, 3, 7, 7, 7, 7);
}

/// a x b of the first three of each half, halved; these are below 2^7 in a and below 2^8 in b.
inline EightShorts half_cross(EightShorts a, EightShorts b) noexcept {
  return rotate(((a * rotate(b)) >> 1) - ((rotate(a) * b) >> 1));
}

namespace plain {

/// The other half is 0.
inline EightShorts load_one(const FourShorts& numbers) noexcept {
  return EightShorts{numbers[0], numbers[1], numbers[2], numbers[3]};
}

inline EightShorts load_two(const FourShorts& first, const FourShorts& second) noexcept {
  return EightShorts{first[0], first[1], first[2], first[3], second[0], second[1], second[2], second[3]};
}

inline EightShorts clamp(EightShorts lanes, std::int16_t least, std::int16_t most) noexcept {
  for (int i = 0; i < 8; ++i) lanes[i] = std::clamp(static_cast<std::int16_t>(lanes[i]), least, most);
  return lanes;
}

/// Sum of the products of each half.
inline std::array<std::int32_t, 2> weigh(EightShorts lanes, EightShorts weights) noexcept {
  std::array<std::int32_t, 2> sums{};
  for (int i = 0; i < 8; ++i) sums[static_cast<std::size_t>(i / 4)] += lanes[i] * weights[i];
  return sums;
}

/// The first half times `factor`, which is below 2^22; the lanes are from -2 to 2.
inline FourInts times(EightShorts lanes, std::int32_t factor) noexcept {
  return FourInts{lanes[0], lanes[1], lanes[2], lanes[3]} * factor;
}

}  // namespace plain

#if defined(__SSE2__)

inline __m128i as_register(EightShorts lanes) noexcept { return reinterpret_cast<__m128i>(lanes); }

inline EightShorts load_one(const FourShorts& numbers) noexcept {
  return reinterpret_cast<EightShorts>(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(numbers.data())));
}

inline EightShorts load_two(const FourShorts& first, const FourShorts& second) noexcept {
  const __m128i low = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(first.data()));
  return reinterpret_cast<EightShorts>(
      _mm_loadh_pi(_mm_castsi128_ps(low), reinterpret_cast<const __m64*>(second.data())));
}

inline EightShorts clamp(EightShorts lanes, std::int16_t least, std::int16_t most) noexcept {
  const __m128i below = _mm_min_epi16(as_register(lanes), _mm_set1_epi16(most));
  return reinterpret_cast<EightShorts>(_mm_max_epi16(below, _mm_set1_epi16(least)));
}

inline std::array<std::int32_t, 2> weigh(EightShorts lanes, EightShorts weights) noexcept {
  const __m128i pairs = _mm_madd_epi16(as_register(lanes), as_register(weights));
  const __m128i sums = _mm_add_epi32(pairs, _mm_shuffle_epi32(pairs, 0xb1));
  return std::bit_cast<std::array<std::int32_t, 2>>(_mm_cvtsi128_si64(_mm_shuffle_epi32(sums, 0x08)));
}

inline FourInts times(EightShorts lanes, std::int32_t factor) noexcept {
  // 256 times as much goes with the factor's upper bits.
  const __m128i both = _mm_unpacklo_epi16(as_register(lanes), as_register(lanes << 8));
  const __m128i factors = _mm_set1_epi32((factor >> 8) << 16 | (factor & 0xff));
  return reinterpret_cast<FourInts>(_mm_madd_epi16(both, factors));
}

#else

using plain::clamp;
using plain::load_one;
using plain::load_two;
using plain::times;
using plain::weigh;

#endif

}  // namespace deltamesh
