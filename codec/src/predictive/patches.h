// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Coordinates that are not on the lattice where all others are, to the last bit [POSN-11]. One template for
// both directions.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "entropy/number_model.h"

namespace deltamesh {

/// A coordinate in place of the lattice's.
struct Patch {
  std::uint64_t coordinate = 0;  ///< 3 times the vertex, plus the axis
  float value = 0;
  bool operator==(const Patch&) const = default;
};

/// `patches`: by ascending coordinate, below `coordinates`; a reader gets them. False where the stream lies.
template <class Coder>
bool code_patches(Coder& coder, std::vector<Patch>& patches, std::uint64_t coordinates) {
  NumberModel counts;
  NumberModel gaps;
  const std::uint32_t count = coder.number(static_cast<std::uint32_t>(patches.size()), counts);
  if (count > coordinates) return false;
  std::uint64_t next = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    Patch patch;
    if constexpr (Coder::kWrites) patch = patches[i];
    next += coder.number(static_cast<std::uint32_t>(patch.coordinate - next), gaps);
    if (next >= coordinates) return false;
    patch.coordinate = next++;
    patch.value = std::bit_cast<float>(coder.bits(std::bit_cast<std::uint32_t>(patch.value), 32));
    if (!std::isfinite(patch.value)) return false;
    if constexpr (!Coder::kWrites) {
      if (coder.failed()) return true;  // which finish() tells
      patches.push_back(patch);
    }
  }
  return true;
}

/// Puts them in their places; `rows`: n x 3.
inline void apply(std::span<const Patch> patches, std::span<float> rows) noexcept {
  for (const Patch& patch : patches) rows[static_cast<std::size_t>(patch.coordinate)] = patch.value;
}

}  // namespace deltamesh
