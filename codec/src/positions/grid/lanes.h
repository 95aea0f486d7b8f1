// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Two times four 16-bit numbers handled at once, for spots of two vertices in their voxel cubes.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "base/simd/eight_shorts.h"

namespace deltamesh {

using FourShorts = std::array<std::int16_t, 4>;

/// Both in memory.
inline std::array<FourShorts, 2> halves_of(EightShorts lanes) noexcept {
  return std::bit_cast<std::array<FourShorts, 2>>(lanes);
}

/// Numbers 1, 2, 0, 3 of each half.
inline EightShorts rotate(EightShorts lanes) noexcept { return pick_lanes<1, 2, 0, 3, 5, 6, 4, 7>(lanes); }

/// The last of each half everywhere in it.
inline EightShorts last_of_half(EightShorts lanes) noexcept {
  return pick_lanes<3, 3, 3, 3, 7, 7, 7, 7>(lanes);
}

inline simde__m128i as_register(EightShorts lanes) noexcept { return reinterpret_cast<simde__m128i>(lanes); }

/// The other half is 0.
inline EightShorts load_one(const FourShorts& numbers) noexcept {
  return reinterpret_cast<EightShorts>(
      simde_mm_loadl_epi64(reinterpret_cast<const simde__m128i*>(numbers.data())));
}

inline EightShorts load_two(const FourShorts& first, const FourShorts& second) noexcept {
  const simde__m128i low = simde_mm_loadl_epi64(reinterpret_cast<const simde__m128i*>(first.data()));
  return reinterpret_cast<EightShorts>(
      simde_mm_loadh_pi(simde_mm_castsi128_ps(low), reinterpret_cast<const simde__m64*>(second.data())));
}

inline EightShorts clamp(EightShorts lanes, std::int16_t least, std::int16_t most) noexcept {
  return larger_lanes(smaller_lanes(lanes, all_lanes(most)), all_lanes(least));
}

/// Sum of the products of each half.
inline std::array<std::int32_t, 2> weigh(EightShorts lanes, EightShorts weights) noexcept {
  const simde__m128i pairs = simde_mm_madd_epi16(as_register(lanes), as_register(weights));
  const simde__m128i sums = simde_mm_add_epi32(pairs, simde_mm_shuffle_epi32(pairs, 0xb1));
  return std::bit_cast<std::array<std::int32_t, 2>>(
      simde_mm_cvtsi128_si64(simde_mm_shuffle_epi32(sums, 0x08)));
}

/// a x b of the first three of each half; the last is 0. Exact where sums of two products are below 2^31.
inline std::array<FourInts, 2> cross(EightShorts a, EightShorts b) noexcept {
  const EightShorts next_a = rotate(a);
  const EightShorts next_b = rotate(b);
  const simde__m128i first = as_register(next_a);
  const simde__m128i last = as_register(rotate(next_a));
  const simde__m128i plus = as_register(rotate(next_b));
  const simde__m128i minus = as_register(-next_b);
  const auto products = [](simde__m128i factors, simde__m128i others) {
    return reinterpret_cast<FourInts>(simde_mm_madd_epi16(factors, others));
  };
  return {products(simde_mm_unpacklo_epi16(first, last), simde_mm_unpacklo_epi16(plus, minus)),
          products(simde_mm_unpackhi_epi16(first, last), simde_mm_unpackhi_epi16(plus, minus))};
}

}  // namespace deltamesh
