// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A coarse graph at a quarter of the cost of P^T K P: the edges between aggregates, as the paths that they
// are on.
#pragma once

#include "laplacian/multigrid_aggregate.h"
#include "laplacian/multigrid_level.h"

namespace deltamesh::multigrid {

/// Edges, weights and degrees of `coarse` from those of `fine`, whose weights are all 1. An edge between two
/// aggregates lies on a path of one to three edges from one seed to the other. As conductors in series these
/// have the weight 1, 1/2 or 1/3; 9/8 of that, summed, is the weight between the aggregates. No worse than
/// P^T K P for what is smooth on a finest level, whose nodes lie about evenly. O(n + edges).
void make_bridge_graph(const Level& fine, const Aggregates& aggregates, Level& coarse);

}  // namespace deltamesh::multigrid
