// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The graph of the next coarser level: edges between aggregates, as the paths that they are on.
#pragma once

#include "laplacian/multigrid/level/level.h"
#include "laplacian/multigrid/setup/aggregates.h"

namespace deltamesh {
class ThreadTeam;
}

namespace deltamesh::multigrid {

/// Edges, weights and degrees of `coarse` from those of `fine` [DELT-7]. An edge between two aggregates lies
/// on a path of one to three edges from one seed to the other, which as conductors in series conduct 1, 1/2
/// or 1/3 of one of them; six fifths of that, summed, is the weight between the aggregates. For what is
/// smooth no worse than P^T K P, with a third of its edges. On the threads of `team`; null: on this one. O(n
/// + edges).
void make_coarse_graph(const Level& fine, const Aggregates& aggregates, bool by_paths, Level& coarse,
                       ThreadTeam* team);

}  // namespace deltamesh::multigrid
