// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Replacements: exact floats in place of lattice points [POSN-11]. One template for both directions.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "base/numbers/vec3.h"
#include "entropy/coder/number_model.h"

namespace deltamesh {

/// The exact value of one coordinate.
struct Replacement {
  std::uint64_t coordinate = 0;  ///< 3 times the vertex, plus the axis
  float value = 0;
  bool operator==(const Replacement&) const = default;
};

/// `replacements`: ascending by coordinate, all below `coordinates`; a reader appends to it. Returns false if
/// the stream breaks [POSN-11].
template <class Coder>
bool code_replacements(Coder& coder, std::vector<Replacement>& replacements, std::uint64_t coordinates) {
  NumberModel counts;
  NumberModel gaps;
  const std::uint32_t count = coder.number(static_cast<std::uint32_t>(replacements.size()), counts);
  if (count > coordinates) return false;
  std::uint64_t next = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    Replacement replacement;
    if constexpr (Coder::kWrites) replacement = replacements[i];
    next += coder.number(static_cast<std::uint32_t>(replacement.coordinate - next), gaps);
    if (next >= coordinates) return false;
    replacement.coordinate = next++;
    replacement.value = std::bit_cast<float>(coder.bits(std::bit_cast<std::uint32_t>(replacement.value), 32));
    if (!std::isfinite(replacement.value)) return false;
    if constexpr (!Coder::kWrites) {
      if (coder.failed()) return true;  // finish() reports it
      replacements.push_back(replacement);
    }
  }
  return true;
}

/// Writes the values into `rows`, n x 3.
inline void apply(std::span<const Replacement> replacements, std::span<float> rows) noexcept {
  for (const Replacement& replacement : replacements)
    rows[static_cast<std::size_t>(replacement.coordinate)] = replacement.value;
}

}  // namespace deltamesh
