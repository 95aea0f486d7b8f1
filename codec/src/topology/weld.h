// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Position welding: vertices with equal position bits are one geometric vertex (DESIGN: no cracks at
// attribute seams).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace deltamesh {

struct Weld {
  std::vector<std::uint32_t>
      geometric;  ///< n: geometric vertex of every vertex, numbered by first appearance
  std::vector<std::uint32_t> representative;  ///< first vertex of every geometric vertex
};

/// `positions`: n x 3, compared bit by bit. `welds`: n flags; a vertex whose flag is 0 stays alone
/// (unreferenced vertices). O(n) expected.
Weld weld_by_position(std::span<const float> positions, std::span<const std::uint8_t> welds);

}  // namespace deltamesh
