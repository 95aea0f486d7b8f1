// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "topology/adjacency.h"

namespace deltamesh {

/// Per anchor 1 if its component has another anchor, else 0. O(components + anchors).
std::vector<std::uint8_t> shared_components(const Components& components,
                                            std::span<const std::uint32_t> anchors);

}  // namespace deltamesh
