// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Quantisation of delta coordinates with error diffusion: the noise is pushed to high frequencies, where the
// least-squares solution does not amplify it. The stream does not change.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/numbers/vec3.h"
#include "deltamesh/result.h"
#include "highpass/delta_quantizer.h"
#include "topology/adjacency.h"

namespace deltamesh {

/// Visits the vertices in order. What the symbol of vertex i leaves over, e_i, is a charge d_i e_i (d_i =
/// degree: d is the left null vector of L = I - D^-1 A, so a sum of charges that is zero costs the lowest
/// frequency nothing). `strength` of it, 0 to 1, goes to the neighbours not yet visited in proportion to
/// their degrees, and each adds its share divided by its own degree to the delta it has to code. At strength
/// 0 every delta is quantised alone. `rate_weight`: 0 takes the nearest symbols, more prefers cheap ones.
/// `deltas`: n; `graph` has no isolated vertices.
/// Returns 3 n symbols: x of every vertex, then y, then z. Errors: kInvalidArgument where a symbol exceeds
/// kLargestSymbol. O(n + edges).
Result<std::vector<std::int32_t>> quantize_deltas(const Adjacency& graph, std::span<const Vec3> deltas,
                                                  const DeltaQuantizer& quantizer, double strength,
                                                  double rate_weight = 0);

}  // namespace deltamesh
