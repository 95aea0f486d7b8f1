// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The coarse graph that keeps the energy of what is interpolated: K_coarse = P^T K P.
#pragma once

#include <cstdint>

#include "laplacian/settling/level.h"

namespace deltamesh::settling {

/// Entries of P^T K P below this share of the largest in their row and in their column are left out.
inline constexpr float kSmallEntry = 0.1F;

/// Edges, weights and degrees of `coarse` (`nodes` of them) from those of `fine` and its interpolation P. An
/// edge's weight is the entry of P^T K P beside the diagonal, negated; edges of negative weight, and those
/// below `smallest` times the largest at both of their ends, are left out. Degrees are sums of weights, so
/// constants stay without energy. False, and nothing made, where there would be more edges than in `fine`.
/// O(n + edges) of `fine`.
bool make_galerkin_graph(const Level& fine, std::uint32_t nodes, float smallest, Level& coarse);

}  // namespace deltamesh::settling
