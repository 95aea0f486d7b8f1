// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Components sorted by how deep their hierarchies go, so that thousands of small ones share the work of few.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "topology/adjacency.h"

namespace deltamesh::settling {

/// Some components of a graph, with their vertices and anchors renumbered in the same order.
struct Group {
  std::uint32_t depth = 0;               ///< coarsenings; 0: to be solved without
  std::vector<std::uint32_t> vertices;   ///< vertex of the whole graph for every vertex here, ascending;
                                         ///< empty: all of them
  std::vector<std::uint32_t> anchors;    ///< vertices here
  std::vector<std::uint32_t> anchor_of;  ///< anchor of the whole problem for every anchor here
  std::unique_ptr<Adjacency> storage;    ///< null where `graph` is the whole graph
  const Adjacency* graph = nullptr;
  Components components;

  std::size_t vertex_count() const noexcept { return graph->vertex_count(); }
};

/// In place of a depth: the component is one of SmallComponents.
inline constexpr std::uint32_t kInNoGroup = ~std::uint32_t{0};

/// Coarsenings of every component. Components of equal depth share a group. Spans as below.
std::vector<std::uint32_t> component_depths(const Adjacency& graph, const Components& components,
                                            std::span<const std::uint32_t> anchors);

/// All components of `graph` but those of SmallComponents by ascending depth. `anchors`: at least one in
/// every component. `graph` must outlive the groups. O(n + edges).
std::vector<Group> group_components(const Adjacency& graph, Components components,
                                    std::span<const std::uint32_t> anchors);

/// The components of `group` that `chosen` (one flag for each) marks, as a group of depth 0 over vertices and
/// anchors of `group`.
Group extract_components(const Group& group, std::span<const std::uint8_t> chosen);

}  // namespace deltamesh::settling
