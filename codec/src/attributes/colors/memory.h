// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The record kept of a coded colour, and the context of the next one [ATTR-48, ATTR-49].
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "base/simd/four_floats.h"
#include "base/simd/four_ints.h"

namespace deltamesh {

inline constexpr std::size_t kColorAxes = 4;
using ColorLevels = std::array<std::int32_t, kColorAxes>;

struct ColorShape {
  unsigned axes;       ///< coded components, 1 to 4
  std::int32_t top;    ///< highest level, 255 or 65535
  std::int32_t bound;  ///< how far a decoded level may be off, below `top`

  std::int32_t step() const noexcept { return 2 * bound + 1; }
};

/// Whether a vertex' colour was copied, and from which candidate.
enum class CopyOutcome : std::uint32_t { kFirst, kOther, kNone, kNothingToCopy };

constexpr bool was_copied(CopyOutcome outcome) noexcept { return outcome <= CopyOutcome::kOther; }

struct ColorMemory {
  FourFloats sizes;  ///< of the differences to what was expected, smoothed, levels
  CopyOutcome outcome;
};

/// The means over the vertices around.
struct ColorAround {
  FourFloats expected{};  ///< within the levels
  FourFloats spread{};    ///< how far from there the colours are
  FourFloats sizes{};
  bool is_first = false;  ///< there are none
};

inline FourFloats floats_of(const ColorLevels& levels) noexcept {
  return FourFloats{static_cast<float>(levels[0]), static_cast<float>(levels[1]),
                    static_cast<float>(levels[2]), static_cast<float>(levels[3])};
}

/// Of whole numbers.
inline ColorLevels levels_of(FourFloats levels) noexcept {
  ColorLevels whole{};
  for (std::size_t a = 0; a < kColorAxes; ++a)
    whole[a] = static_cast<std::int32_t>(levels[static_cast<int>(a)]);
  return whole;
}

/// Not-a-number becomes 0.
inline FourFloats clamped(FourFloats x, std::int32_t top) noexcept {
  const FourFloats none{};
  const FourFloats most = none + static_cast<float>(top);
  x = x > none ? x : none;
  return x < most ? x : most;
}

inline FourFloats sizes_of(FourFloats x) noexcept {
  return std::bit_cast<FourFloats>(std::bit_cast<FourInts>(x) & 0x7fffffff);
}

/// Axes 1 and 2 less axis 0.
inline FourFloats tied(FourFloats x) noexcept { return x - FourFloats{0, x[0], x[0], 0}; }

}  // namespace deltamesh
