// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The number of connected components, without building the graph.
#pragma once

#include <cstdint>
#include <span>

namespace deltamesh {

/// What find_components() of the triangles' graph counts. `triangles`: m x 3 indices below `vertex_count`.
/// Nearly O(n + m).
std::uint32_t count_components(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count);

}  // namespace deltamesh
