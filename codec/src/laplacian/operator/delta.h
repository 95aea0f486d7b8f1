// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Delta coordinates: the umbrella Laplacian L = I - D^-1 A of vertex positions.
#pragma once

#include <span>
#include <vector>

#include "base/numbers/vec3.h"
#include "laplacian/operator/solved_part.h"
#include "topology/adjacency.h"

namespace deltamesh {

/// delta_i = v_i - (1 / d_i) sum_{j in N(i)} v_j, neighbours summed in ascending order; zero for a vertex
/// without neighbours. `positions`: n, model units. O(n + edges). Source: Yang, Li et al., section 3.
std::vector<Vec3> delta_coordinates(const Adjacency& graph, std::span<const Vec3> positions);

/// The same over the rows of `part`; `positions`: n, of the whole graph.
std::vector<Vec3> delta_coordinates(const SolvedPart& part, std::span<const Vec3> positions);

/// Largest minus smallest number among all components of `deltas`: the one range that the quantiser divides.
/// Zero where there are none.
double delta_range(std::span<const Vec3> deltas) noexcept;

}  // namespace deltamesh
