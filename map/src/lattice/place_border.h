// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A decoded part's border vertices at their lattice points [MAP-8], and what is near them.
#pragma once

#include <span>
#include <vector>

#include "deltamesh/map/description.h"
#include "deltamesh/map/part.h"

namespace deltamesh {

/// The positions of border vertices, b x 3.
std::vector<float> positions_of(const Mesh& mesh, std::span<const BorderVertex> border);

/// All positions as the part's stream has them [MAP-26], n x 3.
std::vector<float> streamed_positions(const MapPart& part);

/// Puts border vertices at their points. `spreads`: of a highpass stream, whose errors are alike from vertex
/// to vertex: others move along, less with each edge from the border, so that no step is left there [MAP-20].
/// Vertices with the same position move alike. O(n).
void place_border(Mesh& mesh, std::span<const BorderVertex> border, const MapLattice& lattice, bool spreads);

}  // namespace deltamesh
