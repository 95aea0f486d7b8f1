// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Eight 16-bit numbers handled at once: enough for classes and indices, and twice as many as of 32 bits.
#pragma once

#include <cstdint>

#include "base/simd/four_ints.h"
#include "base/simd/pick_lanes.h"

namespace deltamesh {

using EightShorts = std::int16_t __attribute__((vector_size(16)));
using EightUnsigned = std::uint16_t __attribute__((vector_size(16)));

constexpr EightShorts all_lanes(std::int32_t number) noexcept {
  const auto lane = static_cast<std::int16_t>(number);
  return EightShorts{lane, lane, lane, lane, lane, lane, lane, lane};
}

/// Lanes of `low`, then of `high`, each at least -2^15 and at most 2^15 - 1.
inline EightShorts pack_lanes(FourInts low, FourInts high) noexcept {
  return reinterpret_cast<EightShorts>(
      simde_mm_packs_epi32(reinterpret_cast<simde__m128i>(low), reinterpret_cast<simde__m128i>(high)));
}

/// A bit for every lane of `low` and then of `high` that is below 0.
inline unsigned set_lanes(EightShorts low, EightShorts high) noexcept {
  const auto bytes =
      simde_mm_packs_epi16(reinterpret_cast<simde__m128i>(low), reinterpret_cast<simde__m128i>(high));
  return static_cast<unsigned>(simde_mm_movemask_epi8(bytes));
}

/// The first four lanes.
inline FourInts low_ints(EightShorts lanes) noexcept {
  return reinterpret_cast<FourInts>(pick_lanes<0, 0, 1, 1, 2, 2, 3, 3>(lanes)) >> 16;
}

/// The first four lanes, twice.
inline EightShorts twice_low(EightShorts lanes) noexcept { return pick_lanes<0, 1, 2, 3, 0, 1, 2, 3>(lanes); }

/// Modulo 2^16.
inline EightShorts wrapped_difference(EightShorts a, EightShorts b) noexcept {
  return reinterpret_cast<EightShorts>(reinterpret_cast<EightUnsigned>(a) -
                                       reinterpret_cast<EightUnsigned>(b));
}

/// `of_a`, `of_b`, and so on.
inline EightShorts in_turns(std::int32_t of_a, std::int32_t of_b) noexcept {
  return pick_lanes<0, 8, 1, 9, 2, 10, 3, 11>(all_lanes(of_a), all_lanes(of_b));
}

/// Sums of the products of the first four lanes of `a` and `b` with weights that alternate between the two.
inline FourInts weighted_sums(EightShorts a, EightShorts b, EightShorts weights) noexcept {
  const EightShorts pairs = pick_lanes<0, 8, 1, 9, 2, 10, 3, 11>(a, b);
  return reinterpret_cast<FourInts>(
      simde_mm_madd_epi16(reinterpret_cast<simde__m128i>(pairs), reinterpret_cast<simde__m128i>(weights)));
}

/// The same of the last four lanes.
inline FourInts weighted_high_sums(EightShorts a, EightShorts b, EightShorts weights) noexcept {
  const EightShorts pairs = pick_lanes<4, 12, 5, 13, 6, 14, 7, 15>(a, b);
  return reinterpret_cast<FourInts>(
      simde_mm_madd_epi16(reinterpret_cast<simde__m128i>(pairs), reinterpret_cast<simde__m128i>(weights)));
}

/// Absolute values, of lanes above -2^15.
inline EightShorts lane_sizes(EightShorts lanes) noexcept {
  const EightShorts opposite = -lanes;
  return lanes > opposite ? lanes : opposite;
}

inline EightShorts larger_lanes(EightShorts a, EightShorts b) noexcept { return a > b ? a : b; }
inline EightShorts smaller_lanes(EightShorts a, EightShorts b) noexcept { return a < b ? a : b; }

}  // namespace deltamesh
