// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "positions/lattice/axis_values.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "positions/lattice/lattice.h"
#include "positions/lattice/value_planes.h"
#include "positions/rounding.h"

namespace deltamesh {
namespace {

constexpr std::size_t kSampledValues = 2048;
constexpr std::size_t kFewestRepeats = kSampledValues / 25;

constexpr unsigned kDigits = 3;
constexpr unsigned kDigitBits = 11;
constexpr std::uint32_t kDigitValues = 1U << kDigitBits;

/// Ascends as floats do.
std::uint32_t key_of(double value) noexcept {
  const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
  return bits ^ ((0U - (bits >> 31)) | 0x80000000U);
}
float value_of(std::uint32_t key) noexcept {
  return std::bit_cast<float>(key ^ (((key >> 31) - 1U) | 0x80000000U));
}

constexpr std::uint32_t digit_of(std::uint32_t key, unsigned digit) noexcept {
  return key >> (digit * kDigitBits) & (kDigitValues - 1);
}

double off_comb(double x, double origin, double distance) noexcept {
  const double turns = (x - origin) / distance;
  return std::abs(turns - nearest(turns)) * distance;
}

/// Every `stride`th value of an axis, the first one among them, ascending. O(n): a radix sort.
std::vector<float> sort_values(std::span<const Vec3> positions, std::size_t axis, std::size_t stride) {
  std::vector<std::uint32_t> keys;
  keys.reserve(positions.size() / stride + 1);
  std::array<std::array<std::uint32_t, kDigitValues>, kDigits> places{};
  for (std::size_t v = 0; v < positions.size(); v += stride) {
    const std::uint32_t key = key_of(positions[v][axis]);
    keys.push_back(key);
    for (unsigned digit = 0; digit < kDigits; ++digit) ++places[digit][digit_of(key, digit)];
  }
  std::vector<std::uint32_t> next(keys.size());
  for (unsigned digit = 0; digit < kDigits; ++digit) {
    std::uint32_t sum = 0;
    for (std::uint32_t& place : places[digit]) {
      const std::uint32_t count = place;
      place = sum;
      sum += count;
    }
    for (const std::uint32_t key : keys) next[places[digit][digit_of(key, digit)]++] = key;
    keys.swap(next);
  }
  std::vector<float> values(keys.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = value_of(keys[i]);
  return values;
}

}  // namespace

const std::vector<float>& AxisValues::few(std::size_t axis) const {
  if (few_[axis].empty()) {
    const std::size_t stride = std::max<std::size_t>(positions_.size() / kSampledValues, 1);
    few_[axis] =
        sort_values(positions_.first(std::min(positions_.size(), kSampledValues * stride)), axis, stride);
  }
  return few_[axis];
}

bool AxisValues::has_repeats(std::size_t axis) const {
  if (positions_.size() <= kSampledValues) return true;
  const std::vector<float>& values = few(axis);
  std::size_t repeats = 0;
  for (std::size_t i = 1; i < values.size(); ++i) repeats += values[i] == values[i - 1] ? 1 : 0;
  return repeats >= kFewestRepeats;
}

std::size_t AxisValues::count_distances(std::size_t axis, double least, double most) const {
  const std::vector<float>& values = few(axis);
  std::size_t count = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double distance = double{values[i]} - values[i - 1];
    count += distance > least && distance < most ? 1 : 0;
  }
  return count;
}

std::span<const float> AxisValues::sorted(std::size_t axis) const {
  if (sorted_[axis].empty()) sorted_[axis] = sort_values(positions_, axis, stride_);
  return sorted_[axis];
}

std::array<AxisGrid, 3> fit_axes(const AxisValues& values, const Box& box, double finest) {
  const std::span<const Vec3> positions = values.positions();
  constexpr double kFinestShare = 0.1;
  constexpr double kOff = 0.05;  // sources are rounded, to decimals say
  constexpr std::size_t kMostBetween = 8;
  std::array<AxisGrid, 3> grids{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double noise = std::max(std::abs(box.min[axis]), std::abs(box.max[axis])) * 0x1p-22;
    if (values.count_distances(axis, 2 * noise, finest / 2) > kMostBetween) continue;
    const std::vector<Plane> planes = find_planes(values, axis, noise, 1);
    PlaneComb comb{0, usual_distance(planes, kFinestShare)};
    if (!(comb.distance > std::max(8 * noise, finest))) continue;
    comb.origin = planes[0].place;
    for (const double tolerance : {0.1, 0.05, 0.02}) comb = refine(planes, comb, tolerance);
    const bool all = std::all_of(positions.begin(), positions.end(), [&](const Vec3& position) {
      return off_comb(position[axis], comb.origin, comb.distance) <= 2 * noise + kOff * comb.distance;
    });
    if (!all) continue;
    const double below = std::round((box.min[axis] - comb.origin) / comb.distance);
    const double origin = comb.origin + comb.distance * below;
    grids[axis] = {std::abs(origin - box.min[axis]) <= noise ? box.min[axis] : origin, comb.distance};
  }
  return grids;
}

PositionLattice grid_lattice(const Box& box, const std::array<AxisGrid, 3>& axes, double step) noexcept {
  PositionLattice lattice = cubic_lattice(box, step);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const AxisGrid& grid = axes[axis];
    if (!(lattice.step[axis] <= coarsest_step_on(grid))) continue;
    const double cells = std::round((box.max[axis] - grid.origin) / grid.step);
    if (!(cells <= kMostCells)) continue;
    lattice.origin[axis] = grid.origin;
    lattice.first[axis] = 0;
    lattice.step[axis] = grid.step;
    lattice.cells[axis] = static_cast<std::uint32_t>(cells);
  }
  return lattice;
}

}  // namespace deltamesh
