// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Two doubles handled at once, as of a mesh and of its decoded twin.
#pragma once

#include <cmath>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace deltamesh {

using TwoDoubles = double __attribute__((vector_size(16)));

/// Rounded as std::sqrt() is.
inline TwoDoubles square_roots(TwoDoubles x) noexcept {
#if defined(__SSE2__)
  return _mm_sqrt_pd(x);
#else
  return TwoDoubles{std::sqrt(x[0]), std::sqrt(x[1])};
#endif
}

/// The larger of each pair, `b` where they do not compare.
inline TwoDoubles larger_of(TwoDoubles a, TwoDoubles b) noexcept {
#if defined(__SSE2__)
  return _mm_max_pd(a, b);
#else
  return TwoDoubles{a[0] > b[0] ? a[0] : b[0], a[1] > b[1] ? a[1] : b[1]};
#endif
}

}  // namespace deltamesh
