// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Four floats handled at once.
#pragma once

#include "base/simd/two_doubles.h"

namespace deltamesh {

/// Element-wise arithmetic only, so that every instruction set gives the same bits.
using FourFloats = float __attribute__((vector_size(16)));

inline FourFloats narrow_lanes(TwoDoubles low, TwoDoubles high) noexcept {
  return FourFloats{static_cast<float>(low[0]), static_cast<float>(low[1]), static_cast<float>(high[0]),
                    static_cast<float>(high[1])};
}

/// Rounded as std::sqrt() is.
inline FourFloats square_roots(FourFloats x) noexcept {
  return reinterpret_cast<FourFloats>(simde_mm_sqrt_ps(reinterpret_cast<simde__m128>(x)));
}

/// Dot product of the first three lanes.
inline float dot3(FourFloats a, FourFloats b) noexcept {
  const FourFloats products = a * b;
  return products[0] + products[1] + products[2];
}
inline FourFloats cross3(FourFloats a, FourFloats b) noexcept {
  const FourFloats turned =
      a * __builtin_shufflevector(b, b, 1, 2, 0, 3) - __builtin_shufflevector(a, a, 1, 2, 0, 3) * b;
  return __builtin_shufflevector(turned, turned, 1, 2, 0, 3);
}

}  // namespace deltamesh
