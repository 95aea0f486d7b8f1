// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The least-squares solution [DELT-4]: steps by a cycle through the levels of planned cycles, in doubles; a
// factorisation for components that these do not settle.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "deltamesh/result.h"
#include "laplacian/multigrid/cycle/level_solver.h"
#include "laplacian/multigrid/level/level.h"
#include "laplacian/operator/delta_view.h"
#include "topology/adjacency.h"

namespace deltamesh {
class ThreadTeam;
}

namespace deltamesh::settling {

class SettledSolver {
 public:
  /// `levels`: of `graph`, the finest with weights of its own; `components`: of `graph`, at least one of the
  /// `anchors` in each; `holds`: per anchor 1 if its component has another one. All must outlive this.
  /// `team`: as LevelSolver.
  SettledSolver(const Adjacency& graph, const Components& components, std::span<const std::uint32_t> anchors,
                std::span<const multigrid::Level> levels, const std::vector<std::uint8_t>& holds,
                ThreadTeam* team);

  /// `x`: n, overwritten. Over all vertices, the rms distance to the exact solution that remains is a few
  /// percent of what quantisation leaves; it may be more in a component that is accurate beside others that
  /// are not. Work is bounded: 60 steps of O(n + edges), and at most twice a factorisation of 2^32
  /// multiplications and 200 MB. Errors: kInvalidStream [DELT-4] where the solution is out of reach.
  Result<void> solve(const DeltaView& deltas, std::span<const Vec3> targets, std::span<Vec3> x);

 private:
  struct Problem {
    const DeltaView& deltas;
    std::span<const Vec3> targets;
    double unit;   ///< as Steps
    double noise;  ///< as Convergence
  };
  bool solve_directly(const Problem& problem, std::span<const std::uint8_t> marks, std::span<Vec3> x) const;

  const Adjacency& graph_;
  const Components& components_;
  std::span<const std::uint32_t> anchors_;
  multigrid::LevelSolver cycles_;
};

}  // namespace deltamesh::settling
