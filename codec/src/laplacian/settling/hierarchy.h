// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Builds the levels from connectivity and anchors alone.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "laplacian/settling/level.h"
#include "topology/adjacency.h"

namespace deltamesh::settling {

/// How many times a component of `vertices` with `anchors` is coarsened: at least once, then as long as about
/// as many nodes as anchors will be left.
std::uint32_t coarsening_depth(std::uint32_t vertices, std::uint32_t anchors) noexcept;

/// The finest level and `depth` coarser ones; fewer where coarsening no longer shrinks. `graph` must outlive
/// them. Cost and memory O(n + edges).
std::vector<Level> build_hierarchy(const Adjacency& graph, std::span<const std::uint32_t> anchors,
                                   std::uint32_t depth);

/// Per level, how many cycles are made on it for one on the level before: two from the second level on, or
/// one where levels shrink so slowly that all cycles together would take more than some times the work on the
/// finest level.
std::vector<int> plan_cycles(std::span<const Level> levels);

/// Nodes and edges, each met from both ends: what a sweep over the level costs.
std::uint64_t work_on(const Level& level) noexcept;

}  // namespace deltamesh::settling
