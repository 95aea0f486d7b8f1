// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Eight 16-bit numbers handled at once, for places in a voxel cube: plain and for SSE2, with equal results.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "base/four_ints.h"

namespace deltamesh {

using EightShorts = std::int16_t __attribute__((vector_size(16)));

/// Steps between grid edges are cut here: farther ones are all the same.
inline constexpr std::int16_t kMostSteps = 4;
/// Of index_of_steps(), and what no steps at all have.
inline constexpr std::size_t kStepIndices = 9 * 9 * 9;
constexpr std::size_t step_index(int x, int y, int z) noexcept {
  return static_cast<std::size_t>(((x + kMostSteps) * 9 + y + kMostSteps) * 9 + z + kMostSteps);
}

namespace plain {

inline EightShorts lane_min(EightShorts a, EightShorts b) noexcept {
  for (int i = 0; i < 8; ++i) a[i] = std::min<std::int16_t>(a[i], b[i]);
  return a;
}
inline EightShorts lane_max(EightShorts a, EightShorts b) noexcept {
  for (int i = 0; i < 8; ++i) a[i] = std::max<std::int16_t>(a[i], b[i]);
  return a;
}

/// floor(a * b / 2^16)
inline EightShorts mul_high(EightShorts a, EightShorts b) noexcept {
  for (int i = 0; i < 8; ++i) a[i] = static_cast<std::int16_t>((a[i] * b[i]) >> 16);
  return a;
}

/// The smallest lane.
inline std::int16_t least(EightShorts lanes) noexcept {
  std::int16_t result = lanes[0];
  for (int i = 1; i < 8; ++i) result = std::min<std::int16_t>(result, lanes[i]);
  return result;
}

/// to - from in lanes 0 to 2, at most kMostSteps in size; these are below 2^30 in size.
inline EightShorts steps_between(FourInts from, FourInts to) noexcept {
  EightShorts steps{};
  for (int i = 0; i < 4; ++i) {
    const std::int32_t step = std::clamp<std::int32_t>(to[i] - from[i], -kMostSteps, kMostSteps);
    steps[i] = static_cast<std::int16_t>(step);
    steps[i + 4] = steps[i];
  }
  return steps;
}

/// step_index() of lanes 0 to 2.
inline std::size_t index_of_steps(EightShorts steps) noexcept {
  return step_index(steps[0], steps[1], steps[2]);
}

}  // namespace plain

#if defined(__SSE2__)

inline __m128i as_register(EightShorts lanes) noexcept { return reinterpret_cast<__m128i>(lanes); }

inline EightShorts lane_min(EightShorts a, EightShorts b) noexcept {
  return reinterpret_cast<EightShorts>(_mm_min_epi16(as_register(a), as_register(b)));
}
inline EightShorts lane_max(EightShorts a, EightShorts b) noexcept {
  return reinterpret_cast<EightShorts>(_mm_max_epi16(as_register(a), as_register(b)));
}
inline EightShorts mul_high(EightShorts a, EightShorts b) noexcept {
  return reinterpret_cast<EightShorts>(_mm_mulhi_epi16(as_register(a), as_register(b)));
}

inline std::int16_t least(EightShorts lanes) noexcept {
  __m128i now = as_register(lanes);
  now = _mm_min_epi16(now, _mm_shuffle_epi32(now, 0x4e));
  now = _mm_min_epi16(now, _mm_shuffle_epi32(now, 0xb1));
  now = _mm_min_epi16(now, _mm_srli_epi32(now, 16));
  return static_cast<std::int16_t>(_mm_cvtsi128_si32(now));
}

inline EightShorts steps_between(FourInts from, FourInts to) noexcept {
  const auto apart = reinterpret_cast<__m128i>(to - from);
  const __m128i steps = _mm_packs_epi32(apart, apart);
  const __m128i most = _mm_set1_epi16(kMostSteps);
  const __m128i least = _mm_set1_epi16(-kMostSteps);
  return reinterpret_cast<EightShorts>(_mm_max_epi16(_mm_min_epi16(steps, most), least));
}

inline std::size_t index_of_steps(EightShorts steps) noexcept {
  const __m128i sums = _mm_madd_epi16(as_register(steps), _mm_set_epi16(0, 0, 0, 0, 0, 1, 9, 81));
  const __m128i sum = _mm_add_epi32(sums, _mm_shuffle_epi32(sums, 0x55));
  return static_cast<std::size_t>(_mm_cvtsi128_si32(sum) + static_cast<int>(step_index(0, 0, 0)));
}

#else

using plain::index_of_steps;
using plain::lane_max;
using plain::lane_min;
using plain::least;
using plain::mul_high;
using plain::steps_between;

#endif

}  // namespace deltamesh
