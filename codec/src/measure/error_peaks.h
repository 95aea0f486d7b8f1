// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Finds the local maxima of a decoded mesh's errors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "topology/adjacency.h"

namespace deltamesh {

/// At most `count` vertices whose error is above `threshold`, largest first, the lowest index among equals;
/// none within 3 edges of another one chosen, none with a flag in `excluded`. `errors`, `excluded`: n. O(n
/// log n + the neighbourhoods of those chosen).
std::vector<std::uint32_t> error_peaks(const Adjacency& graph, std::span<const double> errors,
                                       std::span<const std::uint8_t> excluded, double threshold,
                                       std::size_t count);

}  // namespace deltamesh
