// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Axes whose coordinates are whole steps, as quantised sources and heights over a grid have them. Encoder
// only.
#pragma once

#include <array>

#include "base/vec3.h"
#include "format/predictive_parameters.h"
#include "predictive/axis_values.h"

namespace deltamesh {

/// An axis whose coordinates are all whole steps from `origin`, but for rounding.
struct AxisGrid {
  double origin = 0;
  double step = 0;  ///< 0 where there is none
};

/// Of all vertices, not only those of the sample. `finest`: a smaller step is not looked for. O(n).
std::array<AxisGrid, 3> fit_axes(const AxisValues& values, const Box& box, double finest = 0);

/// cubic_lattice(), but with the own steps of axes that have a grid not much finer.
PositionLattice grid_lattice(const Box& box, const std::array<AxisGrid, 3>& axes, double step) noexcept;

}  // namespace deltamesh
