// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Finds the lattice whose points, rounded to floats, are a source's coordinates bit by bit, but for few:
// decimals, metres of a terrain's grid, whole numbers. Encoder only.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/numbers/vec3.h"
#include "format/predictive_parameters.h"
#include "positions/lattice/replacements.h"

namespace deltamesh {

/// `positions`: floats, in `box`. Empty where an axis has no such lattice of at most kMostCells. O(n), and
/// little where the first vertices rule it out.
std::optional<PositionLattice> find_exact_lattice(std::span<const Vec3> positions, const Box& box);

/// One replacement for every coordinate of `positions` whose float differs in any bit from that of `decoded`.
std::vector<Replacement> find_replacements(std::span<const Vec3> positions, std::span<const Vec3> decoded);

}  // namespace deltamesh
