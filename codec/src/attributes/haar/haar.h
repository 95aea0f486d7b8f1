// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Colours of 8 bits at a mean error: a transform over the mesh. No chunk carries it yet [HAAR-*].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "attributes/haar/levels.h"
#include "attributes/surface.h"
#include "attributes/values.h"
#include "deltamesh/result.h"

namespace deltamesh {

inline constexpr std::uint32_t kMostHaarStep = 65535;

/// `colors`: n x 3 levels of the vertices of `levels`, which make_haar_levels() made. `step`: of a
/// coefficient, 64ths of a level, 1 to kMostHaarStep; the rms of all errors is about 0.3 of it. O(n), as
/// often as wanted for the same levels.
CodedValues<std::byte> write_haar_colors(std::span<const std::uint8_t> colors,
                                         std::span<const HaarLevel> levels, std::uint32_t step);

/// n x 3 levels. O(n), without recursion. Errors: kTruncated, kInvalidStream [HAAR-6, CMP-3].
Result<std::vector<std::byte>> read_haar_colors(std::span<const std::byte> bytes,
                                                const AttributeSurface& surface);

}  // namespace deltamesh
