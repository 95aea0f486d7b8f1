// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/cycle.h"

#include <cstddef>

#include "laplacian/anchors/shared_components.h"
#include "laplacian/settling/smoother.h"
#include "laplacian/settling/transfer.h"

namespace deltamesh::settling {
namespace {

/// Sweeps on the finest level before a correction: what interpolation leaves there must not reach coarser
/// levels.
constexpr int kFirstSweeps = 3;

}  // namespace

CoupledCycle::CoupledCycle(std::span<const Level> levels, const Components& components, bool is_last_resort)
    : finest_(levels.front()),
      solver_(levels, 0, shared_components(components, finest_.anchors), components.count, is_last_resort),
      targets_(finest_.anchors.size()) {}

void CoupledCycle::start() {
  solver_.begin();
  LevelSolver::Vectors& finest = solver_.vectors(0);
  for (const std::uint32_t anchor : finest_.anchors) finest.b[anchor].s = Float4{};
  if (solver_.bottom() > 0) {
    LevelSolver::Vectors& next = solver_.vectors(1);
    restrict_rows(finest_, finest.b, next.b);
    next.gaps = targets_;
    solver_.solve(1);
    prolong_rows(finest_, next.u, finest.u);
    finest.forces = next.forces;
  } else {
    finest.gaps = targets_;
    solver_.solve(0);
  }
  for (std::size_t a = 0; a < finest.forces.size(); ++a) force(a) = finest.forces[a];
}

void CoupledCycle::cycle() {
  LevelSolver::Vectors& finest = solver_.vectors(0);
  for (std::size_t a = 0; a < finest.gaps.size(); ++a) finest.gaps[a] = targets_[a] + force(a);
  if (solver_.bottom() > 0) {
    for (int sweep = 0; sweep < kFirstSweeps; ++sweep) smooth(finest_, finest.b, finest.u);
    restrict_residual(finest_, finest.b, finest.u, solver_.vectors(1).b);
    solver_.correct_from_next(0);
    return;
  }
  solver_.solve(0);
  for (std::size_t a = 0; a < finest.forces.size(); ++a) force(a) += finest.forces[a];
}

}  // namespace deltamesh::settling
