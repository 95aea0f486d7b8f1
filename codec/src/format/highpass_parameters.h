// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The part of the header that belongs to the highpass geometry coder.
#pragma once

#include <cstdint>

namespace deltamesh {

/// How far towards zero symbols are reconstructed, in 256ths of the step [DELT-2].
struct ReconstructionShift {
  std::int8_t one = 0;   ///< for symbols of magnitude 1
  std::int8_t more = 0;  ///< for larger ones
  bool operator==(const ReconstructionShift&) const = default;
};

/// Largest number of planned cycles that a stream may have [HDR-11, DELT-7]. The encoder tries fewer.
inline constexpr std::uint8_t kMostCycles = 80;

/// Bits of an anchor's coordinate [HDR-11, ANCH-1].
inline constexpr std::uint8_t kLeastAnchorBits = 4;
inline constexpr std::uint8_t kMostAnchorBits = 24;

/// The header's fields for a highpass stream [HDR-11].
struct HighpassParameters {
  std::uint8_t bits = 0;  ///< asked bits, 3 to 16; 0 where a step was asked. For information
  double step = 0;        ///< quantisation step of delta coordinates, model units, finite, above 0
  ReconstructionShift shift{};
  std::uint8_t anchor_bits = 12;     ///< kLeastAnchorBits to kMostAnchorBits
  std::uint32_t anchors = 0;         ///< their number
  std::uint32_t anchor_density = 0;  ///< largest hops of a vertex to its nearest anchor. For information
  std::uint8_t cycles = 1;           ///< planned, 1 to kMostCycles [DELT-7]
};

}  // namespace deltamesh
