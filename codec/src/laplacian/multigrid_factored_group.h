// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A group whose components are factored: where iterations would not settle.
#pragma once

#include <memory>
#include <span>

#include "base/vec3.h"
#include "deltamesh/result.h"
#include "laplacian/delta_view.h"
#include "laplacian/multigrid_groups.h"
#include "laplacian/solver.h"

namespace deltamesh::multigrid {

class FactoredGroup {
 public:
  /// Errors: kInvalidStream where the factorisation fails.
  static Result<std::unique_ptr<FactoredGroup>> make(Group group);

  /// Spans as LeastSquaresSolver::solve, over what the group was taken from; other vertices' x stays.
  Result<void> solve(const DeltaView& deltas, std::span<const Vec3> anchor_positions, std::span<Vec3> x);

 private:
  Group group_;
  std::unique_ptr<LeastSquaresSolver> direct_;
};

}  // namespace deltamesh::multigrid
