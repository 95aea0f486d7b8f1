// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From positions to lattice coordinates and back. The way there is the encoder's.
#pragma once

#include <span>
#include <vector>

#include "base/memory/large_vector.h"
#include "base/numbers/vec3.h"
#include "format/predictive_parameters.h"
#include "positions/blend/blend.h"

namespace deltamesh {

/// The step of one cell less than kMostCells along the longest side of `box`, model units.
double finest_step(const Box& box) noexcept;

/// The cubic lattice of `step` over `box`, of whole steps from 0 unless that is too far off; the step is made
/// larger where a side would take more than kMostCells. `step`: model units, above 0.
PositionLattice cubic_lattice(const Box& box, double step) noexcept;

/// The nearest point of `lattice` for every position.
std::vector<Cell> to_cells(std::span<const Vec3> positions, const PositionLattice& lattice);

LargeVector<Vec3> to_positions(std::span<const Cell> cells, const PositionLattice& lattice);

}  // namespace deltamesh
