// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A coarse graph at a third of the cost of P^T K P: what flows between aggregates.
#pragma once

#include "laplacian/multigrid_aggregate.h"
#include "laplacian/multigrid_level.h"

namespace deltamesh::multigrid {

/// As make_galerkin_graph, from A = -Q^T K P in place of -P^T K P, Q being 1 where a node belongs to an
/// aggregate: an edge's weight is half the sum of its two entries of A, those not above 0 left out. As right
/// as P^T K P for what is smooth, so for the first coarsening; not for one after the other.
bool make_flux_graph(const Level& fine, const Aggregates& aggregates, float smallest, Level& coarse);

}  // namespace deltamesh::multigrid
