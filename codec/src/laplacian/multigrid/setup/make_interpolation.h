// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Interpolation of a level from its aggregates.
#pragma once

#include "base/memory/large_vector.h"
#include "laplacian/multigrid/level/interpolation.h"
#include "laplacian/multigrid/level/level.h"
#include "laplacian/multigrid/setup/aggregates.h"

namespace deltamesh {
class ThreadTeam;
}

namespace deltamesh::multigrid {

/// n rows of P: a seed from its own aggregate alone, any other node from the three aggregates with most of
/// its neighbours, seeds counting four times [DELT-7]. On the threads of `team`; null: on this
/// one. O(n + edges).
LargeVector<Interpolation> make_interpolation(const Level& fine, const Aggregates& aggregates,
                                              ThreadTeam* team = nullptr);

}  // namespace deltamesh::multigrid
