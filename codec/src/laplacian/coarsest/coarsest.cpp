// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/coarsest/coarsest.h"

#include <cstddef>
#include <utility>

#include "laplacian/multigrid/level/edges.h"
#include "laplacian/multigrid/setup/levels.h"

namespace deltamesh::multigrid {
namespace {

std::vector<double> inverses(const LargeVector<float>& masses) {
  std::vector<double> result;
  for (const float mass : masses) result.push_back(1 / static_cast<double>(mass));
  return result;
}

}  // namespace

CoarsestSolver::CoarsestSolver(const Level& level, std::vector<std::uint8_t> holds,
                               std::vector<std::uint32_t> components)
    : level_(level),
      holds_(std::move(holds)),
      inverse_mass_(inverses(level.mass)),
      x_(level.node_count()),
      scaled_(level.node_count()) {
  if (level.node_count() < kFewestNodesToCoarsen) {
    factor_.emplace(level, inverse_mass_);
  } else {
    conjugate_gradients_.emplace(level, inverse_mass_, std::move(components));
  }
}

/// Of K times `values`.
Double4 CoarsestSolver::row_of_k(std::uint32_t i, const LargeVector<Double4>& values) const noexcept {
  return static_cast<double>(level_.degree[i]) * values[i] -
         Edges(level_).sum_all(i, [&](std::uint32_t node) { return values[node]; });
}

void CoarsestSolver::solve(const CoupledProblem& problem) {
  const std::uint32_t n = level_.node_count();
  for (std::uint32_t i = 0; i < n; ++i) scaled_[i] = inverse_mass_[i] * widen(problem.b[i].x);
  for (std::uint32_t i = 0; i < n; ++i) x_[i] = row_of_k(i, scaled_) - widen(problem.b[i].s);
  for (std::size_t a = 0; a < holds_.size(); ++a) x_[level_.anchors[a]] += widen(problem.gaps[a]);
  if (factor_) {
    factor_->solve(x_);
  } else {
    conjugate_gradients_->solve(x_);
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const Double4 s = inverse_mass_[i] * (widen(problem.b[i].x) - row_of_k(i, x_));
    problem.u[i] = {narrow(x_[i]), narrow(s)};
  }
  for (std::size_t a = 0; a < holds_.size(); ++a) {
    const Double4& x = x_[level_.anchors[a]];
    problem.forces[a] = holds_[a] != 0 ? narrow(x - widen(problem.gaps[a])) : Float4{};
  }
}

}  // namespace deltamesh::multigrid
