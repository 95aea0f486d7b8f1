// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "geometry/cycle_plan.h"

#include <algorithm>
#include <cmath>

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

}  // namespace deltamesh
