// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A finest level that is the coarsest one as well: the least-squares solution [DELT-7].
#pragma once

#include <span>

#include "base/numbers/vec3.h"
#include "laplacian/coarsest/envelope_factor.h"
#include "laplacian/multigrid/level/level.h"
#include "laplacian/operator/delta_view.h"

namespace deltamesh::multigrid {

/// `targets`: of the level's anchors; `x`: n, overwritten; `factor`: any, overwritten. O(n w^2), w being what
/// the rows of the factor have.
void solve_directly(const Level& finest, const DeltaView& deltas, std::span<const Vec3> targets,
                    EnvelopeFactor& factor, std::span<Vec3> x);

}  // namespace deltamesh::multigrid
