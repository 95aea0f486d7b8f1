// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Figures as the header declares them: floats, and never better than what was measured.
#pragma once

#include <cmath>
#include <limits>

namespace deltamesh {

/// The smallest float that is not below `value`, which is 0 or more; infinity where there is none.
inline float round_up(double value) noexcept {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  if (value > static_cast<double>(std::numeric_limits<float>::max())) return kInfinity;
  const auto rounded = static_cast<float>(value);
  return static_cast<double>(rounded) >= value ? rounded : std::nextafter(rounded, kInfinity);
}

}  // namespace deltamesh
