// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Area-weighted vertex normals.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.h"

namespace deltamesh {

/// `v` at length 1, or zero where it has no direction.
Vec3 unit_or_zero(const Vec3& v) noexcept;

/// One unit normal per vertex: the sum of its triangles' normals, each as long as twice the area; zero where
/// nothing is left of the sum. `group`: n, vertices with one number (below n) share one normal. `triangles`:
/// m x 3 indices below n. O(n + m).
std::vector<Vec3> vertex_normals(std::span<const Vec3> positions, std::span<const std::uint32_t> triangles,
                                 std::span<const std::uint32_t> group);

/// Between two directions, degrees, 0 to 180; accurate near 0.
double angle_degrees(const Vec3& a, const Vec3& b) noexcept;

}  // namespace deltamesh
