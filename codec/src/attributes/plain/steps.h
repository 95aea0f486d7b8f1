// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The lattice of one component in the plain form [PLN-6].
#pragma once

#include <cmath>
#include <cstdint>

#include "base/byte_reader.h"
#include "base/try.h"

namespace deltamesh {

inline constexpr std::int64_t kLargestPlainFirst = std::int64_t{1} << 52;  ///< either sign

struct PlainSteps {
  double step = 0;         ///< finite, 0 or above; with 0 numbers are the bits of values
  std::int64_t first = 0;  ///< that number 0 stands for, in steps; at most kLargestPlainFirst in size

  bool is_exact() const noexcept { return step == 0; }
  /// One rounding, or none where 0 is meant.
  double at(std::uint64_t number) const noexcept {
    return step * static_cast<double>(first + static_cast<std::int64_t>(number));
  }
};

/// Errors: kTruncated, kInvalidStream [PLN-6].
inline Result<PlainSteps> read_steps(ByteReader& in) {
  PlainSteps steps;
  DELTAMESH_TRY(steps.step, in.read<double>());
  if (!(steps.step >= 0 && std::isfinite(steps.step)))
    return in.invalid("a step that is not finite, or below 0", "PLN-6");
  if (steps.is_exact()) return steps;
  DELTAMESH_TRY(steps.first, in.read<std::int64_t>());
  if (steps.first < -kLargestPlainFirst || steps.first > kLargestPlainFirst)
    return in.invalid("a first number beyond 2^52", "PLN-6");
  return steps;
}

}  // namespace deltamesh
