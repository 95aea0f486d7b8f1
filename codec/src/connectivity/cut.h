// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Cuts any triangle soup into oriented manifold sheets with boundary, by saying which half-edges are matched
// and which corners share a manifold vertex.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace deltamesh {

inline constexpr std::uint32_t kNoIndex = 0xffffffff;

/// Half-edge h of face h / 3 runs from corner h to corner next_in_face(h); corners and half-edges share their
/// numbers.
constexpr std::uint32_t next_in_face(std::uint32_t h) noexcept { return h % 3 == 2 ? h - 2 : h + 1; }
constexpr std::uint32_t previous_in_face(std::uint32_t h) noexcept { return h % 3 == 0 ? h + 2 : h - 1; }

struct ManifoldCut {
  std::vector<std::uint32_t> opposite;         ///< 3m: matched half-edge in the other direction, or kNoIndex
  std::vector<std::uint32_t> manifold_vertex;  ///< 3m: manifold vertex of every corner
  std::vector<std::uint32_t> vertex;           ///< input vertex of every manifold vertex
};

/// `triangles`: m x 3 indices below `vertex_count`, m at most 2^29. Half-edges are matched in pairs of
/// opposite direction; a face with a repeated vertex stays unmatched. A manifold vertex is one fan of corners
/// linked through matched edges. The three corners of a face always have different manifold vertices.
/// O(n + m), times a logarithm for edges around a vertex of high degree.
ManifoldCut cut_to_manifold(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count);

}  // namespace deltamesh
