// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Two doubles handled at once, as of a mesh and of its decoded twin.
#pragma once

#include <simde/x86/sse2.h>

#include "base/machine.h"

namespace deltamesh {

using TwoDoubles = double __attribute__((vector_size(16)));

/// Rounded as std::sqrt() is.
inline TwoDoubles square_roots(TwoDoubles x) noexcept {
  return reinterpret_cast<TwoDoubles>(simde_mm_sqrt_pd(reinterpret_cast<simde__m128d>(x)));
}

/// The larger of each pair, `b` where they do not compare.
inline TwoDoubles larger_of(TwoDoubles a, TwoDoubles b) noexcept { return a > b ? a : b; }

}  // namespace deltamesh
