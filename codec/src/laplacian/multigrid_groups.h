// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Components sorted by how deep their hierarchies go, so that thousands of small ones share the work of few.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "topology/adjacency.h"

namespace deltamesh::multigrid {

/// Some components of a graph, with their vertices and anchors renumbered in the same order.
struct Group {
  std::uint32_t depth = 0;               ///< coarsenings; 0: so small that it is solved directly
  std::vector<std::uint32_t> vertices;   ///< vertex of the whole graph for every vertex here, ascending
  std::vector<std::uint32_t> anchors;    ///< vertices here
  std::vector<std::uint32_t> anchor_of;  ///< anchor of the whole problem for every anchor here
  Adjacency graph;
  Components components;
};

/// All components of `graph` by ascending depth. `anchors`: at least one in every component. O(n + edges).
std::vector<Group> group_components(const Adjacency& graph, std::span<const std::uint32_t> anchors);

/// The components of `group` that `chosen` (one flag for each) marks, as a group of depth 0 over vertices and
/// anchors of `group`.
Group extract_components(const Group& group, std::span<const std::uint8_t> chosen);

}  // namespace deltamesh::multigrid
