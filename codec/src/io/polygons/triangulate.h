// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Polygons to triangles.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/numbers/vec3.h"

namespace deltamesh {

/// Largest polygon that no fan fills: the cost grows with the square of its corners.
constexpr std::size_t kMostEarCorners = 4096;

/// Appends n - 2 triangles of a polygon of n >= 3 `points`, as numbers of its corners; they turn as it does.
/// Where the fan around corner 0 fills the polygon, it is that fan; else corners ("ears") are cut off one by
/// one. What is not planar is seen along the axis nearest to its normal; where that picture crosses itself,
/// the triangles overlap. Decided by exact signs: the same on all machines. False, with a fan appended: a
/// polygon of more than kMostEarCorners corners that a fan does not fill. Cost O(n) for fans, else O(n^2).
/// Source: Meisters 1975, Polygons have ears; O'Rourke 1998, Computational Geometry in C, 1.6.5.
bool triangulate(std::span<const Vec3> points, std::vector<std::uint32_t>& triangles);

}  // namespace deltamesh
