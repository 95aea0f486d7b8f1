// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "positions/lattice/lattice.h"

#include <algorithm>
#include <cmath>

namespace deltamesh {

double finest_step(const Box& box) noexcept { return box.longest_side() / (kMostCells - 1) * (1 + 1e-9); }

PositionLattice cubic_lattice(const Box& box, double step) noexcept {
  step = std::max(step, finest_step(box));
  PositionLattice lattice{.step = {step, step, step}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double first = std::round(box.min[axis] / step);
    if (!(std::abs(first) <= kMostFirst)) {
      lattice.origin[axis] = box.min[axis];
      first = 0;
    }
    const double last = std::round((box.max[axis] - lattice.origin[axis]) / step);
    lattice.first[axis] = static_cast<std::int64_t>(first);
    lattice.cells[axis] = static_cast<std::uint32_t>(std::clamp(last - first, 0.0, double{kMostCells}));
  }
  return lattice;
}

std::vector<Cell> to_cells(std::span<const Vec3> positions, const PositionLattice& lattice) {
  std::vector<Cell> cells;
  reserve_large(cells, positions.size());
  cells.resize(positions.size());
  for (std::size_t v = 0; v < cells.size(); ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double q = (positions[v][axis] - lattice.origin[axis]) / lattice.step[axis] -
                       static_cast<double>(lattice.first[axis]);
      cells[v][axis] =
          static_cast<std::int32_t>(std::clamp(q, 0.0, static_cast<double>(lattice.cells[axis])) + 0.5);
    }
  }
  return cells;
}

LargeVector<Vec3> to_positions(std::span<const Cell> cells, const PositionLattice& lattice) {
  LargeVector<Vec3> positions(cells.size());
  for (std::size_t v = 0; v < cells.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis) positions[v][axis] = lattice.at(axis, cells[v][axis]);
  return positions;
}

}  // namespace deltamesh
