// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Faces across edges, among those that come earlier.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace deltamesh {

inline constexpr std::uint32_t kNoFace = std::numeric_limits<std::uint32_t>::max();

/// For every face and each of its edges: the last face before it that has the edge too, or kNoFace.
/// `triangles`: m x 3 indices below `vertex_count`. O(m log d) for vertices of d edges.
std::vector<std::array<std::uint32_t, 3>> earlier_neighbors(std::span<const std::uint32_t> triangles,
                                                            std::size_t vertex_count);

}  // namespace deltamesh
