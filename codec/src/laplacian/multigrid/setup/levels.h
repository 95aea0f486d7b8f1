// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Builds the levels from connectivity and anchors alone.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "laplacian/multigrid/level/level.h"
#include "topology/adjacency.h"

namespace deltamesh::multigrid {

/// Levels with fewer nodes are not coarsened but solved exactly.
inline constexpr std::uint32_t kFewestNodesToCoarsen = 200;

/// The finest level and all coarser ones [DELT-7]. `graph`, whose vertices have neighbours, must outlive
/// them. On the threads of `team`; null: on this one. Cost and memory O(n + edges).
std::vector<Level> build_levels(const Adjacency& graph, std::span<const std::uint32_t> anchors,
                                ThreadTeam* team = nullptr);

/// Gives the finest level what coarser ones have: the weights of 1, and what follows from them.
void add_weights(Level& finest);

/// Degree of a node of the finest level, whose weights are 1.
inline float unit_degree(const Level& finest, std::uint32_t node) noexcept {
  return static_cast<float>(finest.offsets[node + 1] - finest.offsets[node]);
}

}  // namespace deltamesh::multigrid
