// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/coarsest/coarsest.h"

#include <cstddef>

#include "laplacian/multigrid/level/edges.h"
#include "laplacian/multigrid/setup/levels.h"

namespace deltamesh::multigrid {
namespace {

Double4 widened(const Vec3& v) noexcept { return {TwoDoubles{v[0], v[1]}, TwoDoubles{v[2], 0}}; }

std::vector<double> inverses(const LargeVector<float>& masses) {
  std::vector<double> result;
  for (const float mass : masses) result.push_back(1 / static_cast<double>(mass));
  return result;
}

}  // namespace

CoarsestSolver::CoarsestSolver(const Level& level)
    : level_(level),
      inverse_mass_(inverses(level.mass)),
      x_(level.node_count()),
      scaled_(level.node_count()) {
  if (level.node_count() < kFewestNodesToCoarsen) {
    factor_.emplace().factor(level);
  } else {
    conjugate_gradients_.emplace(level, inverse_mass_);
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
  for (std::size_t a = 0; a < level_.anchors.size(); ++a) x_[level_.anchors[a]] += widen(problem.gaps[a]);
  if (factor_) {
    factor_->solve(x_);
  } else {
    conjugate_gradients_->solve(x_);
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const Double4 s = inverse_mass_[i] * (widen(problem.b[i].x) - row_of_k(i, x_));
    problem.u[i] = {narrow(x_[i]), narrow(s)};
  }
  const bool is_alone = level_.anchors.size() == 1;
  for (std::size_t a = 0; a < level_.anchors.size(); ++a)
    problem.forces[a] = is_alone ? Float4{} : narrow(x_[level_.anchors[a]] - widen(problem.gaps[a]));
}

void solve_directly(const Level& finest, const DeltaView& deltas, std::span<const Vec3> targets,
                    EnvelopeFactor& factor, std::span<Vec3> x) {
  std::vector<Double4> shares;  // of delta, for each neighbour
  std::vector<Double4> sums;
  for (std::uint32_t i = 0; i < finest.node_count(); ++i)
    shares.push_back(1.0 / unit_degree(finest, i) * widened(deltas[i]));
  for (std::uint32_t i = 0; i < finest.node_count(); ++i) {
    Double4 sum = widened(deltas[i]);
    for (std::uint32_t e = finest.offsets[i]; e < finest.offsets[i + 1]; ++e)
      sum -= shares[finest.neighbors[e]];
    sums.push_back(sum);
  }
  for (std::size_t a = 0; a < targets.size(); ++a) sums[finest.anchors[a]] += widened(targets[a]);
  factor.factor(finest);
  factor.solve(sums);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = {sums[i].xy[0], sums[i].xy[1], sums[i].zw[0]};
}

}  // namespace deltamesh::multigrid
