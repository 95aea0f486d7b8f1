// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Rounding to float32 that no compiler leaves out.
#pragma once

namespace deltamesh {

/// `x` as a float. Through memory: GCC 12 drops the rounding where it vectorises conversions to float and
/// back, as in TwoDoubles{double{float(a)}, double{float(b)}}.
inline float rounded(double x) noexcept {
  volatile float result = static_cast<float>(x);
  return result;
}

}  // namespace deltamesh
