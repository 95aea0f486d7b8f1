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

/// `graph`, which must outlive it, with its anchors.
Level finest_level(const Adjacency& graph, std::span<const std::uint32_t> anchors);

/// The finest level and all coarser ones [DELT-7]. `graph`, which is connected, must outlive them; `anchors`:
/// at least one. On the threads of `team`; null: on this one. Cost and memory O(n + edges).
std::vector<Level> build_levels(const Adjacency& graph, std::span<const std::uint32_t> anchors,
                                ThreadTeam* team = nullptr);

}  // namespace deltamesh::multigrid
