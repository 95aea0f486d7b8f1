// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Where the anchors go: breadth-first farthest points, so that no vertex is far from one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "topology/adjacency.h"

namespace deltamesh {

/// Components with fewer vertices are not solved: every vertex of them is an anchor [ANCH-2].
inline constexpr std::uint32_t kSmallestSolvedComponent = 8;

/// At most one of the two; neither means one anchor for every 200 vertices of the solved components.
struct AnchorRequest {
  std::optional<std::uint32_t> count{};    ///< over the solved components; at least one each is made
  std::optional<std::uint32_t> density{};  ///< largest hop distance of a vertex to its nearest anchor
};

struct Anchors {
  std::vector<std::uint32_t> vertices;  ///< ascending
  std::uint32_t density = 0;            ///< largest hop distance of a vertex to its nearest anchor
};

/// One for every 200 vertices, rounded up.
std::uint32_t default_anchor_count(std::size_t solved_vertices) noexcept;

/// One anchor in every solved component, farthest from its lowest vertex; then always the vertex that is
/// farthest (in edges) from all anchors, the lowest index among equals, until the request is met; and every
/// vertex of the small components. Cost O(n + edges) times a small factor that grows with log(anchors): a new
/// anchor's search visits only the vertices that it comes nearer to.
Anchors place_anchors(const Adjacency& graph, const Components& components, const AnchorRequest& request);

}  // namespace deltamesh
