// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "predictive/axis_grid.h"

#include <algorithm>
#include <cmath>

#include "predictive/lattice.h"
#include "predictive/rounding.h"
#include "predictive/value_planes.h"

namespace deltamesh {
namespace {

double off_comb(double x, double origin, double distance) noexcept {
  const double turns = (x - origin) / distance;
  return std::abs(turns - nearest(turns)) * distance;
}

}  // namespace

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
  constexpr double kNotMuchFiner = 0.6;
  PositionLattice lattice = cubic_lattice(box, step);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const AxisGrid& grid = axes[axis];
    if (!(grid.step > kNotMuchFiner * lattice.step[axis])) continue;
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
