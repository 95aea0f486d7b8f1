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

inline EightShorts larger_lanes(EightShorts a, EightShorts b) noexcept { return a > b ? a : b; }
inline EightShorts smaller_lanes(EightShorts a, EightShorts b) noexcept { return a < b ? a : b; }

}  // namespace deltamesh
