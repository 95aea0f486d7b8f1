// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A solver that the highpass encoder uses many times.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "laplacian/operator/solved_part.h"
#include "laplacian/solver.h"

namespace deltamesh {

/// Solves for a part again and again; what was set up for a set of anchors is kept until they change.
class PartSolver {
 public:
  explicit PartSolver(const SolvedPart& part) : part_(part) {}

  /// As LeastSquaresSolver::solve; `anchors`: rows of the part, ascending.
  Result<void> solve(std::span<const std::uint32_t> anchors, const DeltaView& deltas,
                     std::span<const Vec3> anchor_positions, int cycles, std::span<Vec3> x);

  /// Gives memory back: the next solve starts from nothing.
  void forget() noexcept { solver_.reset(); }

 private:
  const SolvedPart& part_;
  std::vector<std::uint32_t> anchors_;
  std::optional<LeastSquaresSolver> solver_;
};

}  // namespace deltamesh
