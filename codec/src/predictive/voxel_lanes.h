// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Eight 16-bit numbers handled at once, for spots in a voxel cube: plain and for SSE2, with equal results.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "base/four_ints.h"

namespace deltamesh {

using EightShorts = std::int16_t __attribute__((vector_size(16)));
using FourShorts = std::array<std::int16_t, 4>;

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

inline EightShorts all_lanes(std::int16_t value) noexcept { return EightShorts{} + value; }

/// Numbers of a cube's edges; kNone where there is only one.
struct NearestEdges {
  static constexpr unsigned kNone = 12;
  unsigned nearest;
  unsigned next;
};

namespace plain {

inline EightShorts load(const FourShorts& numbers) noexcept {
  return EightShorts{numbers[0], numbers[1], numbers[2], numbers[3]};
}
inline FourShorts store(EightShorts lanes) noexcept { return {lanes[0], lanes[1], lanes[2], lanes[3]}; }

inline EightShorts clamp(EightShorts lanes, std::int16_t least, std::int16_t most) noexcept {
  for (int i = 0; i < 8; ++i) lanes[i] = std::clamp(static_cast<std::int16_t>(lanes[i]), least, most);
  return lanes;
}

/// floor(a * b / 2^16)
inline EightShorts mul_high(EightShorts a, EightShorts b) noexcept {
  for (int i = 0; i < 8; ++i) a[i] = static_cast<std::int16_t>((a[i] * b[i]) >> 16);
  return a;
}

/// Sum of the first four products.
inline std::int32_t weigh(EightShorts lanes, const FourShorts& weights) noexcept {
  std::int32_t sum = 0;
  for (int i = 0; i < 4; ++i) sum += lanes[i] * weights[static_cast<std::size_t>(i)];
  return sum;
}

inline FourInts widen(EightShorts lanes) noexcept { return FourInts{lanes[0], lanes[1], lanes[2], lanes[3]}; }

/// a x b, of the first three lanes; these are below 2^15 in size.
inline FourInts cross(EightShorts a, EightShorts b) noexcept {
  return FourInts{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0], 0};
}

/// The two edges of `set`, not empty, that are nearest to a spot [VOX-3]. Of edge 4 k + i the score is
/// own[k], less or plus the spot's two other coordinates as i says, -128 at least; of equal ones the lower
/// number comes first. `spot`, `own`: lanes 0 to 2, from -48 to 48.
inline NearestEdges nearest_edges(EightShorts spot, EightShorts own, unsigned set) noexcept {
  unsigned best = 0xffff;
  unsigned second = 0xffff;
  for (int edge = 0; edge < 12; ++edge) {
    if ((set >> edge & 1) == 0) continue;
    const int axis = edge / 4;
    const int next = spot[(axis + 1) % 3];
    const int last = spot[(axis + 2) % 3];
    const int score = own[axis] + (edge % 2 != 0 ? -next : next) + (edge % 4 >= 2 ? -last : last);
    const auto key = static_cast<unsigned>(16 * (std::max(score, -128) + 128) + edge);
    second = std::min(second, std::max(best, key));
    best = std::min(best, key);
  }
  return {best % 16, second == 0xffff ? NearestEdges::kNone : second % 16};
}

}  // namespace plain

#if defined(__SSE2__)

inline __m128i as_register(EightShorts lanes) noexcept { return reinterpret_cast<__m128i>(lanes); }

/// The other four are 0.
inline EightShorts load(const FourShorts& numbers) noexcept {
  return reinterpret_cast<EightShorts>(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(numbers.data())));
}
inline FourShorts store(EightShorts lanes) noexcept {
  return std::bit_cast<FourShorts>(_mm_cvtsi128_si64(as_register(lanes)));
}

inline EightShorts clamp(EightShorts lanes, std::int16_t least, std::int16_t most) noexcept {
  const __m128i below = _mm_min_epi16(as_register(lanes), _mm_set1_epi16(most));
  return reinterpret_cast<EightShorts>(_mm_max_epi16(below, _mm_set1_epi16(least)));
}

inline EightShorts mul_high(EightShorts a, EightShorts b) noexcept {
  return reinterpret_cast<EightShorts>(_mm_mulhi_epi16(as_register(a), as_register(b)));
}

inline std::int32_t weigh(EightShorts lanes, const FourShorts& weights) noexcept {
  const __m128i sums = _mm_madd_epi16(as_register(lanes), as_register(load(weights)));
  return _mm_cvtsi128_si32(_mm_add_epi32(sums, _mm_shuffle_epi32(sums, 0x55)));
}

inline FourInts widen(EightShorts lanes) noexcept {
  const __m128i twice = _mm_unpacklo_epi16(as_register(lanes), as_register(lanes));
  return reinterpret_cast<FourInts>(_mm_srai_epi32(twice, 16));
}

inline FourInts cross(EightShorts a, EightShorts b) noexcept {
  const __m128i a_twice = _mm_unpacklo_epi64(as_register(a), as_register(a));
  const __m128i b_twice = _mm_unpacklo_epi64(as_register(b), as_register(b));
  // a: 1 2, 2 0, 0 1; b: 2 1, 0 2, 1 0
  const __m128i ahead = _mm_shufflehi_epi16(_mm_shufflelo_epi16(a_twice, 0x29), 0xf4);
  const __m128i behind = _mm_shufflehi_epi16(_mm_shufflelo_epi16(b_twice, 0x86), 0xf1);
  const __m128i odd = _mm_set1_epi32(static_cast<int>(0xffff0000));
  return reinterpret_cast<FourInts>(_mm_madd_epi16(ahead, _mm_sub_epi16(_mm_xor_si128(behind, odd), odd)));
}

/// The smallest of sixteen unsigned bytes, in all.
inline __m128i least_byte(__m128i bytes) noexcept {
  bytes = _mm_min_epu8(bytes, _mm_shuffle_epi32(bytes, 0x4e));
  bytes = _mm_min_epu8(bytes, _mm_shuffle_epi32(bytes, 0xb1));
  bytes = _mm_min_epu8(bytes, _mm_or_si128(_mm_srli_epi32(bytes, 16), _mm_slli_epi32(bytes, 16)));
  return _mm_min_epu8(bytes, _mm_or_si128(_mm_srli_epi16(bytes, 8), _mm_slli_epi16(bytes, 8)));
}

/// Which of the bytes is the first of the smallest.
inline unsigned first_least(__m128i bytes) noexcept {
  const auto least = static_cast<unsigned>(_mm_movemask_epi8(_mm_cmpeq_epi8(bytes, least_byte(bytes))));
  return static_cast<unsigned>(std::countr_zero(least));
}

/// Ones in all bytes whose bit in `set`, of twelve, is clear.
inline __m128i bytes_outside(unsigned set) noexcept {
  const __m128i bits = _mm_set_epi8(-128, 64, 32, 16, 8, 4, 2, 1, -128, 64, 32, 16, 8, 4, 2, 1);
  const __m128i twelve = _mm_cvtsi32_si128(static_cast<int>(set));
  const __m128i twice = _mm_unpacklo_epi8(twelve, twelve);  // of the low eight bits, then of the others
  const __m128i sets = _mm_shuffle_epi32(_mm_shufflelo_epi16(twice, 0x50), 0x50);
  return _mm_cmpeq_epi8(_mm_and_si128(sets, bits), _mm_setzero_si128());
}

/// 16 of these from 15 - i on: ones in byte i.
inline constexpr std::array<std::uint8_t, 31> kOneByte = [] {
  std::array<std::uint8_t, 31> bytes{};
  bytes[15] = 0xff;
  return bytes;
}();

inline NearestEdges nearest_edges(EightShorts spot, EightShorts own, unsigned set) noexcept {
  // Four bytes for each axis, whose places are the numbers of the edges.
  const __m128i both = _mm_packs_epi16(_mm_unpacklo_epi64(as_register(spot), as_register(own)), __m128i{});
  const __m128i twice_spot = _mm_unpacklo_epi8(both, both);
  const __m128i spots = _mm_unpacklo_epi16(twice_spot, twice_spot);
  const __m128i owns = _mm_unpackhi_epi16(twice_spot, twice_spot);
  const __m128i odd = _mm_set1_epi32(static_cast<int>(0xff00ff00));
  const __m128i upper = _mm_set1_epi32(static_cast<int>(0xffff0000));
  const __m128i next = _mm_sub_epi8(_mm_xor_si128(_mm_shuffle_epi32(spots, 0xc9), odd), odd);
  const __m128i last = _mm_sub_epi8(_mm_xor_si128(_mm_shuffle_epi32(spots, 0xd2), upper), upper);
  const __m128i scores = _mm_adds_epi8(_mm_adds_epi8(owns, next), last);
  // None is 255 but those outside of the set.
  const __m128i keys = _mm_or_si128(_mm_xor_si128(scores, _mm_set1_epi8(-128)), bytes_outside(set));
  const unsigned nearest = first_least(keys);
  if ((set & (set - 1)) == 0) return {nearest, NearestEdges::kNone};
  const __m128i taken = _mm_loadu_si128(reinterpret_cast<const __m128i*>(kOneByte.data() + (15 - nearest)));
  return {nearest, first_least(_mm_or_si128(keys, taken))};
}

#else

using plain::clamp;
using plain::cross;
using plain::load;
using plain::mul_high;
using plain::nearest_edges;
using plain::store;
using plain::weigh;
using plain::widen;

#endif

}  // namespace deltamesh
