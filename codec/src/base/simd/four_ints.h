// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Four 32-bit numbers handled at once.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "base/numbers/mean.h"
#include "base/simd/four_floats.h"
#include "base/simd/pick_lanes.h"
#include "base/simd/two_doubles.h"

#ifdef __wasm_simd128__
#include <wasm_simd128.h>
#endif

namespace deltamesh {

using FourInts = std::int32_t __attribute__((vector_size(16)));
using FourUnsigned = std::uint32_t __attribute__((vector_size(16)));

inline FourInts four_ints(const std::array<std::uint32_t, 4>& numbers) noexcept {
  return std::bit_cast<FourInts>(numbers);
}

/// Three numbers and a 0.
inline FourInts four_ints(const std::array<std::int32_t, 3>& numbers) noexcept {
  return reinterpret_cast<FourInts>(
      simde_mm_unpacklo_epi64(simde_mm_loadl_epi64(reinterpret_cast<const simde__m128i*>(numbers.data())),
                              simde_mm_cvtsi32_si128(numbers[2])));
}

/// The first two lanes.
inline TwoDoubles low_doubles(FourInts lanes) noexcept {
  return reinterpret_cast<TwoDoubles>(simde_mm_cvtepi32_pd(reinterpret_cast<simde__m128i>(lanes)));
}

/// All but the last, in pieces that four_ints() soon after finds as they were written.
inline void store_three(FourInts lanes, std::array<std::int32_t, 3>& numbers) noexcept {
  simde_mm_storel_epi64(reinterpret_cast<simde__m128i*>(numbers.data()),
                        reinterpret_cast<simde__m128i>(lanes));
  numbers[2] = lanes[2];
}

/// A bit for every lane that is below 0.
inline unsigned set_lanes(FourInts lanes) noexcept {
  return static_cast<unsigned>(simde_mm_movemask_ps(reinterpret_cast<simde__m128>(lanes)));
}

/// About every lane / count, rounded down: (lane * kOneOver[count]) >> 16. Lanes are below 2^30 + 2^28 in
/// size.
inline FourInts mean_lanes(FourInts lanes, unsigned count) noexcept {
  // With the bias added, products of unsigned numbers do.
  constexpr std::uint32_t kBias = 5U << 28;
  const auto one_over = static_cast<std::int32_t>(kOneOver[count]);
  const FourUnsigned sums = reinterpret_cast<FourUnsigned>(lanes) + kBias;
  const auto biased = reinterpret_cast<simde__m128i>(sums);
  const simde__m128i factor = simde_mm_set1_epi32(one_over);
  const simde__m128i even = simde_mm_srli_epi64(simde_mm_mul_epu32(biased, factor), 16);
  const simde__m128i odd =
      simde_mm_slli_epi64(simde_mm_mul_epu32(simde_mm_srli_epi64(biased, 32), factor), 16);
  const simde__m128i high_halves = simde_mm_set_epi32(-1, 0, -1, 0);
  const auto means = reinterpret_cast<FourInts>(
      simde_mm_or_si128(simde_mm_andnot_si128(high_halves, even), simde_mm_and_si128(high_halves, odd)));
  return means - static_cast<std::int32_t>(kBias >> 16) * one_over;
}

/// Rounded to the nearest, ties to even.
inline FourFloats to_floats(FourInts lanes) noexcept { return __builtin_convertvector(lanes, FourFloats); }

/// A third of the lanes' sum, rounded down, in every lane. No lane is below 0, the sum is below 2^31.
inline FourInts third_of_sum(FourInts lanes) noexcept {
  const FourInts halves = lanes + pick_lanes<2, 3, 0, 1>(lanes);
  const FourInts sum = halves + pick_lanes<1, 0, 3, 2>(halves);
  // Exact below 2^31: the factor is 2^32 / 3 and 2 / 3 more.
  const auto thirds = reinterpret_cast<FourInts>(
      simde_mm_mul_epu32(reinterpret_cast<simde__m128i>(sum), simde_mm_set1_epi32(0x55555556)));
  return pick_lanes<1, 1, 3, 3>(thirds);
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
#ifdef __wasm_simd128__  // as SSE2, which WebAssembly has no such instruction of
  const FourInts fits = (lanes >= -0x1p31F) & (lanes < 0x1p31F);
  const auto whole = reinterpret_cast<FourInts>(
      wasm_i32x4_trunc_sat_f32x4(wasm_f32x4_nearest(reinterpret_cast<v128_t>(lanes))));
  return (whole & fits) | (INT32_MIN & ~fits);
#else
  return reinterpret_cast<FourInts>(simde_mm_cvtps_epi32(reinterpret_cast<simde__m128>(lanes)));
#endif
}

inline FourInts nearest_lanes(TwoDoubles low, TwoDoubles high) noexcept {
  const auto nearest = [](double number) {
    constexpr double kNoFraction = 0x1.8p52;  // so large that what is added becomes a whole number
    const double whole = (number + kNoFraction) - kNoFraction;
    return std::abs(whole) < 0x1p31 ? static_cast<std::int32_t>(whole) : INT32_MIN;
  };
  return FourInts{nearest(low[0]), nearest(low[1]), nearest(high[0]), nearest(high[1])};
}

/// Absolute values.
inline FourInts lane_sizes(FourInts lanes) noexcept {
  const FourInts sign = lanes >> 31;
  return (lanes ^ sign) - sign;
}

}  // namespace deltamesh
