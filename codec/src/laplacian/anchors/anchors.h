// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Vertices whose positions a highpass stream tells.
#pragma once

#include <cstdint>
#include <vector>

namespace deltamesh {

/// Components with fewer vertices are not solved: every vertex of them is an anchor [ANCH-2].
inline constexpr std::uint32_t kSmallestSolvedComponent = 8;

struct Anchors {
  std::vector<std::uint32_t> vertices;  ///< ascending
  std::uint32_t density = 0;            ///< largest hop distance of a vertex to its nearest anchor
};

}  // namespace deltamesh
