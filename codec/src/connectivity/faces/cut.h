// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Cuts any triangle soup into oriented manifold sheets with boundary, by saying which half-edges are matched.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace deltamesh {

inline constexpr std::uint32_t kNoIndex = 0xffffffff;

/// Half-edge h of face h / 3 runs from corner h to corner next_in_face(h); corners and half-edges share their
/// numbers. No branches: they would go wrong one time in three.
constexpr std::uint32_t next_in_face(std::uint32_t h) noexcept { return h + 1 - 3U * (h % 3 == 2); }
constexpr std::uint32_t previous_in_face(std::uint32_t h) noexcept { return h - 1 + 3U * (h % 3 == 0); }

struct HalfEdges {
  /// The half-edge matched to each of the 3m, in the other direction between the same vertices, or kNoIndex.
  std::vector<std::uint32_t> opposite;
  /// All half-edges between two vertices except one and its match, vertex by vertex.
  std::vector<std::uint32_t> repeated;
  bool degenerate = false;  ///< some face has a vertex twice
};

/// `triangles`: m x 3 indices below `vertex_count`, m at most 2^29. A face with a repeated vertex stays
/// unmatched. The corners linked through matched half-edges at a vertex are a fan: one manifold vertex. The
/// three corners of a face are always in different fans. O(n + m), times a logarithm for edges of more than
/// two faces.
HalfEdges match_half_edges(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count);

}  // namespace deltamesh
