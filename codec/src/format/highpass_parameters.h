// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The part of the header that belongs to the highpass geometry coder.
#pragma once

#include <cstdint>

namespace deltamesh {

/// What the header says of a highpass stream [HDR-11].
struct HighpassParameters {
  std::uint8_t bits = 0;             ///< asked bits, 3 to 16; 0 where a step was asked. For information
  double step = 0;                   ///< quantisation step of delta coordinates, model units, finite, above 0
  std::uint8_t anchor_bits = 12;     ///< 4 to 24
  std::uint32_t anchors = 0;         ///< their number
  std::uint32_t anchor_density = 0;  ///< largest hops of a vertex to its nearest anchor. For information
};

}  // namespace deltamesh
