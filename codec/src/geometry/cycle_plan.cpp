// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "geometry/cycle_plan.h"

#include <algorithm>
#include <cmath>

namespace deltamesh {
namespace {

/// What a plan may cost, over the rms and the largest distance to the true positions, and over the rms error
/// of the delta coordinates, which is what the eye sees. [DELT-6] asks for less than a quarter of the first
/// between plan and exact solution.
constexpr double kRms = 1.015;
constexpr double kLargest = 1.04;
constexpr double kRoughness = 1.01;
constexpr double kApart = 0.18;

struct Distances {
  double rms = 0;
  double largest = 0;
};

Distances distances(const SolvedPart& part, std::span<const Vec3> a, std::span<const Vec3> b) {
  double sum = 0;
  double largest = 0;
  for (std::size_t row = 0; row < part.row_count; ++row) {
    const Vec3 difference = a[part.vertex(row)] - b[part.vertex(row)];
    sum += dot(difference, difference);
    largest = std::max(largest, dot(difference, difference));
  }
  return {.rms = std::sqrt(sum / static_cast<double>(part.row_count)), .largest = std::sqrt(largest)};
}

/// Rms of the delta coordinates of a - b.
double roughness(const SolvedPart& part, std::span<const Vec3> a, std::span<const Vec3> b) {
  const auto error = [&](std::uint32_t row) { return a[part.vertex(row)] - b[part.vertex(row)]; };
  double squares = 0;
  for (std::uint32_t row = 0; row < part.row_count; ++row) {
    Vec3 sum{};
    for (const std::uint32_t neighbor : part.graph.of(row)) sum = sum + error(neighbor);
    const Vec3 delta = error(row) - (1.0 / part.graph.degree(row)) * sum;
    squares += dot(delta, delta);
  }
  return std::sqrt(squares / static_cast<double>(part.row_count));
}

}  // namespace

bool is_as_good(const SolvedPart& part, std::span<const Vec3> positions, std::span<const Vec3> settled,
                std::span<const Vec3> solution, double invisible) {
  if (part.row_count == 0) return true;
  const Distances before = distances(part, positions, settled);
  const Distances after = distances(part, positions, solution);
  const Distances apart = distances(part, settled, solution);
  return after.rms <= std::max(kRms * before.rms, invisible) &&
         after.largest <= std::max(kLargest * before.largest, invisible) &&
         apart.rms <= std::max(kApart * before.rms, invisible) &&
         roughness(part, positions, solution) <=
             std::max(kRoughness * roughness(part, positions, settled), invisible);
}

}  // namespace deltamesh
