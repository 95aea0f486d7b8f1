// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "highpass/cycles/compensation.h"

#include <algorithm>
#include <cmath>

#include "base/try.h"
#include "laplacian/operator/delta.h"

namespace deltamesh {
namespace {

double unit_for(std::span<const Vec3> positions, const Vec3& center) noexcept {
  double largest = 0;
  for (const Vec3& position : positions) largest = std::max(largest, length(position - center));
  return largest > 0 ? std::ldexp(1.0, std::ilogb(largest)) : 1.0;
}

bool is_finite(const Vec3& v) noexcept {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

}  // namespace

Compensation::Compensation(const SolvedPart& part, std::span<const Vec3> positions, const Vec3& center,
                           const Box& anchors)
    : part_(&part),
      positions_(positions),
      center_(center),
      box_(anchors),
      unit_(unit_for(positions, center)),
      shifted_(positions.begin(), positions.end()),
      deltas_(delta_coordinates(part, shifted_)) {}

Compensation::Problem Compensation::problem(std::span<const std::uint32_t> anchors) const {
  const double per_unit = 1 / unit_;
  Problem problem;
  problem.deltas.reserve(deltas_.size());
  for (const Vec3& delta : deltas_) problem.deltas.push_back(per_unit * delta);
  problem.targets.reserve(anchors.size());
  for (const std::uint32_t row : anchors) {
    Vec3 target = shifted_[part_->vertex(row)];
    for (std::size_t axis = 0; axis < 3; ++axis)
      target[axis] = std::clamp(target[axis], box_.min[axis], box_.max[axis]);
    problem.targets.push_back(per_unit * (target - center_));
  }
  return problem;
}

Result<PlanErrors> Compensation::improve(PlannedSolver& solver, std::span<const std::uint32_t> anchors,
                                         int cycles) {
  const auto [deltas, targets] = problem(anchors);
  std::vector<Vec3> x(part_->row_count);
  DELTAMESH_CHECK(solver.solve(anchors, deltas, targets, cycles, x));
  if (!std::all_of(x.begin(), x.end(), is_finite))
    return Error{.code = ErrorCode::kInvalidStream, .message = "planned cycles diverge", .rule = "DELT-7"};
  for (std::uint32_t row = 0; row < x.size(); ++row) {
    x[row] = left_out(row, x[row]);
    Vec3& shifted = shifted_[part_->vertex(row)];
    shifted = shifted + x[row];
  }
  deltas_ = delta_coordinates(*part_, shifted_);
  return errors_of(part_->graph, x);
}

Result<void> Compensation::follow(PlannedSolver& solver, std::span<const std::uint32_t> anchors,
                                  const PlannedSolver::Look& look) const {
  const auto [deltas, targets] = problem(anchors);
  std::vector<Vec3> left(part_->row_count);
  return solver.follow(anchors, deltas, targets, [&](int cycles, std::span<const Vec3> x) {
    for (std::uint32_t row = 0; row < x.size(); ++row) left[row] = left_out(row, x[row]);
    return look(cycles, left);
  });
}

}  // namespace deltamesh
