// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Sixteen 16-bit numbers handled at once: the inner loops of the compact coder, plain and for SSE2, with
// equal results.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace deltamesh {

inline constexpr unsigned kSymbols = 16;

using Lanes = std::array<std::int16_t, kSymbols>;

/// From lane s on all bits set.
inline constexpr std::array<Lanes, kSymbols> kLaneMasks = [] {
  std::array<Lanes, kSymbols> masks{};
  for (unsigned s = 0; s < kSymbols; ++s)
    for (unsigned i = s; i < kSymbols; ++i) masks[s][i] = -1;
  return masks;
}();

namespace plain {

/// lane += ((mask of `symbol` & goal) - lane) >> rate
constexpr void pull_lanes(Lanes& lanes, unsigned symbol, std::int16_t goal, unsigned rate) noexcept {
  for (unsigned i = 0; i < kSymbols; ++i)
    lanes[i] = static_cast<std::int16_t>(lanes[i] + (((kLaneMasks[symbol][i] & goal) - lanes[i]) >> rate));
}

/// sum += lanes * weight / 2^15, rounded down; `weight` below 2^16, lanes not negative.
constexpr void add_weighted(Lanes& sum, const Lanes& lanes, std::uint32_t weight) noexcept {
  for (unsigned i = 0; i < kSymbols; ++i) {
    const std::uint32_t twice = 2 * static_cast<std::uint32_t>(lanes[i]);
    sum[i] = static_cast<std::int16_t>(sum[i] + static_cast<std::int32_t>((twice * weight) >> 16));
  }
}

/// The number of lanes that are at most `value`.
constexpr unsigned count_up_to(const Lanes& lanes, std::int16_t value) noexcept {
  unsigned count = 0;
  for (const std::int16_t lane : lanes) count += lane <= value ? 1 : 0;
  return count;
}

}  // namespace plain

#if defined(__SSE2__)

inline __m128i load_lanes(const Lanes& lanes, std::size_t half) noexcept {
  return _mm_loadu_si128(reinterpret_cast<const __m128i*>(lanes.data() + 8 * half));
}
inline void store_lanes(Lanes& lanes, std::size_t half, __m128i value) noexcept {
  _mm_storeu_si128(reinterpret_cast<__m128i*>(lanes.data() + 8 * half), value);
}

inline void pull_lanes(Lanes& lanes, unsigned symbol, std::int16_t goal, unsigned rate) noexcept {
  const __m128i goals = _mm_set1_epi16(goal);
  const __m128i shift = _mm_cvtsi32_si128(static_cast<int>(rate));
  for (std::size_t half = 0; half < 2; ++half) {
    const __m128i now = load_lanes(lanes, half);
    const __m128i way = _mm_sub_epi16(_mm_and_si128(load_lanes(kLaneMasks[symbol], half), goals), now);
    store_lanes(lanes, half, _mm_add_epi16(now, _mm_sra_epi16(way, shift)));
  }
}

inline void add_weighted(Lanes& sum, const Lanes& lanes, std::uint32_t weight) noexcept {
  const __m128i weights = _mm_set1_epi16(static_cast<std::int16_t>(weight));
  for (std::size_t half = 0; half < 2; ++half) {
    const __m128i twice = _mm_slli_epi16(load_lanes(lanes, half), 1);
    store_lanes(sum, half, _mm_add_epi16(load_lanes(sum, half), _mm_mulhi_epu16(twice, weights)));
  }
}

inline unsigned count_up_to(const Lanes& lanes, std::int16_t value) noexcept {
  const __m128i values = _mm_set1_epi16(value);
  const __m128i low = _mm_cmpgt_epi16(load_lanes(lanes, 0), values);
  const __m128i high = _mm_cmpgt_epi16(load_lanes(lanes, 1), values);
  // One bit per lane that is larger; the lanes never fall, so the first of them tells.
  const auto larger = static_cast<unsigned>(_mm_movemask_epi8(_mm_packs_epi16(low, high)));
  return static_cast<unsigned>(std::countr_zero(larger | 1U << kSymbols));
}

#else

using plain::add_weighted;
using plain::count_up_to;
using plain::pull_lanes;

#endif

}  // namespace deltamesh
