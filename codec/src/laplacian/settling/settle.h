// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The least-squares solution [DELT-4]: steps by a cycle through the levels of planned cycles, in doubles; a
// factorisation for components that these do not settle.
#pragma once

#include <span>

#include "base/numbers/vec3.h"
#include "deltamesh/result.h"
#include "laplacian/settling/problem.h"

namespace deltamesh {
class ThreadTeam;
}

namespace deltamesh::settling {

/// `x`: n, overwritten. Over all vertices, the rms distance to the exact solution that remains is a few
/// percent of what quantisation leaves; it may be more in a component that is accurate beside others that
/// are not. Small components are solved together, some 4096 vertices at a time. Work is bounded: 60 steps of
/// O(n + edges), and factorisations of 2^33 multiplications in all, each of at most half of them and 200 MB.
/// `team`: as LevelSolver. Errors: kInvalidStream [DELT-4] where the solution is out of reach.
Result<void> settle(const Problem& problem, ThreadTeam* team, std::span<Vec3> x);

}  // namespace deltamesh::settling
