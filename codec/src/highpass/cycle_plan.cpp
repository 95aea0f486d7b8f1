// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "highpass/cycle_plan.h"

#include <algorithm>
#include <cmath>

#include "base/try.h"
#include "laplacian/operator/delta.h"

namespace deltamesh {
namespace {

/// In model units.
PlanCost errors(const SolvedPart& part, std::span<const Vec3> a, std::span<const Vec3> b) {
  const auto error = [&](std::uint32_t row) { return a[part.vertex(row)] - b[part.vertex(row)]; };
  double squares = 0;
  double largest = 0;
  double delta_squares = 0;
  for (std::uint32_t row = 0; row < part.row_count; ++row) {
    const Vec3 own = error(row);
    squares += dot(own, own);
    largest = std::max(largest, dot(own, own));
    Vec3 sum{};
    for (const std::uint32_t neighbor : part.graph.of(row)) sum = sum + error(neighbor);
    const Vec3 delta = own - (1.0 / part.graph.degree(row)) * sum;
    delta_squares += dot(delta, delta);
  }
  const auto count = static_cast<double>(part.row_count);
  return {.rms = std::sqrt(squares / count),
          .largest = std::sqrt(largest),
          .roughness = std::sqrt(delta_squares / count)};
}

double unit_for(std::span<const Vec3> positions, const Vec3& center) noexcept {
  double largest = 0;
  for (const Vec3& position : positions) largest = std::max(largest, length(position - center));
  return largest > 0 ? std::ldexp(1.0, std::ilogb(largest)) : 1.0;
}

bool is_finite(const Vec3& v) noexcept {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

}  // namespace

PlanJudge::PlanJudge(const SolvedPart& part, std::span<const Vec3> positions, std::span<const Vec3> settled,
                     double invisible)
    : part_(part), positions_(positions), invisible_(invisible), settled_(errors(part, positions, settled)) {}

PlanCost PlanJudge::cost(std::span<const Vec3> solution) const {
  const PlanCost now = errors(part_, positions_, solution);
  const auto ratio = [&](double figure, double settled) {
    return figure <= invisible_ ? 0 : figure / settled;
  };
  return {.rms = ratio(now.rms, settled_.rms),
          .largest = ratio(now.largest, settled_.largest),
          .roughness = ratio(now.roughness, settled_.roughness)};
}

Compensation::Compensation(const SolvedPart& part, std::span<const Vec3> positions, const Vec3& center)
    : part_(part),
      positions_(positions),
      center_(center),
      unit_(unit_for(positions, center)),
      shifted_(positions.begin(), positions.end()),
      deltas_(delta_coordinates(part, shifted_)) {}

Result<void> Compensation::improve(LeastSquaresSolver& solver, std::span<const std::uint32_t> anchors,
                                   int cycles) {
  const double per_unit = 1 / unit_;
  std::vector<Vec3> targets;
  for (const std::uint32_t row : anchors)
    targets.push_back(per_unit * (shifted_[part_.vertex(row)] - center_));
  std::vector<Vec3> deltas;
  for (const Vec3& delta : deltas_) deltas.push_back(per_unit * delta);
  std::vector<Vec3> x(part_.row_count);
  DELTAMESH_CHECK(solver.solve(anchors, deltas, targets, cycles, x));
  if (!std::all_of(x.begin(), x.end(), is_finite))
    return Error{.code = ErrorCode::kInvalidStream, .message = "planned cycles diverge", .rule = "DELT-7"};
  for (std::size_t row = 0; row < x.size(); ++row) {
    const std::uint32_t v = part_.vertex(row);
    shifted_[v] = shifted_[v] + (positions_[v] - (center_ + unit_ * x[row]));
  }
  deltas_ = delta_coordinates(part_, shifted_);
  return {};
}

}  // namespace deltamesh
