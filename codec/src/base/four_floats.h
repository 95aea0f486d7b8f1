// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Four floats handled at once.
#pragma once

#include "base/two_doubles.h"

namespace deltamesh {

/// Element-wise arithmetic only, so that every instruction set gives the same bits.
using FourFloats = float __attribute__((vector_size(16)));

inline FourFloats narrow_lanes(TwoDoubles low, TwoDoubles high) noexcept {
  return FourFloats{static_cast<float>(low[0]), static_cast<float>(low[1]), static_cast<float>(high[0]),
                    static_cast<float>(high[1])};
}

/// Rounded as std::sqrt() is.
inline FourFloats square_roots(FourFloats x) noexcept {
#if defined(__SSE2__)
  return _mm_sqrt_ps(x);
#else
  return FourFloats{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
#endif
}

}  // namespace deltamesh
