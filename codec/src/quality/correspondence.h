// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Whether the vertices of two meshes stand for each other.
#pragma once

#include <cstdint>
#include <span>

namespace deltamesh {

/// Whether the triangles of `b`, their indices mapped by `order`, are exactly those of `a`: the same
/// orientation, any rotation within a triangle, any sequence of triangles, each as often. `order`: one vertex
/// of `a` for every vertex of `b`, every index below `a_vertices`; each at most once, or the answer is no.
/// Cost O(m log m).
bool triangles_correspond(std::span<const std::uint32_t> a, std::size_t a_vertices,
                          std::span<const std::uint32_t> b, std::span<const std::uint32_t> order);

}  // namespace deltamesh
