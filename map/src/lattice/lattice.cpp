// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "deltamesh/map/description.h"
#include "support/limits.h"

namespace deltamesh {
namespace {

/// 2^exponent, a normal double.
double power_of_two(int exponent) noexcept {
  return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
}

/// Exact: the sum of a float32 in steps below 2^24 and a half has at most 53 bits that count, and where it
/// has more, the half is of no account.
double nearest_step(float x, double steps_per_unit) noexcept {
  return std::floor(double{x} * steps_per_unit + 0.5);
}

}  // namespace

double MapLattice::step() const noexcept { return power_of_two(step_exponent); }

LatticePoint MapLattice::nearest(const std::array<float, 3>& position) const noexcept {
  const double steps_per_unit = power_of_two(-step_exponent);
  LatticePoint point{};
  for (std::size_t k = 0; k < 3; ++k)
    point[k] = static_cast<std::int32_t>(nearest_step(position[k], steps_per_unit));
  return point;
}

bool MapLattice::is_within(const std::array<float, 3>& position) const noexcept {
  const double steps_per_unit = power_of_two(-step_exponent);
  return std::ranges::all_of(position, [&](float x) {
    const double step = nearest_step(x, steps_per_unit);
    return step >= -kMostLatticeSteps && step <= kMostLatticeSteps;
  });
}

std::array<float, 3> MapLattice::position_of(const LatticePoint& point) const noexcept {
  std::array<float, 3> position{};
  for (std::size_t k = 0; k < 3; ++k) position[k] = static_cast<float>(point[k] * step());
  return position;
}

int step_exponent_for(double max_error) noexcept {
  int exponent = kMostStepExponent;
  while (exponent > kLeastStepExponent && !(3 * power_of_two(2 * exponent) <= 4 * max_error * max_error))
    --exponent;
  return exponent;
}

}  // namespace deltamesh
