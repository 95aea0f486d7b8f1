// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Choice of a mesh's origin, the same for all importers.
#pragma once

#include <cstdint>
#include <span>

#include "deltamesh/io.h"

namespace deltamesh {

/// A mesh of vertices alone, `coordinates` (n x 3, model units) split into an origin and float32 positions.
/// An axis gets an origin other than 0 only where the centre of the bounding box is farther from 0 than 4
/// times its longest side; that origin is the centre as a float32, and a whole number where the longest side
/// exceeds 2. NaN and infinities stay what they are and do not count for the box, nor do vertices that no
/// corner names, unless there are no corners: one that nobody sees must not cost the others their digits.
/// Cost O(n).
Mesh place_origin(std::span<const double> coordinates, std::span<const std::uint32_t> corners = {});

/// The same for the origin and the positions of imported.mesh, with what the rounding to float32 took away:
/// Imported::roundings, ReadReport::position_error, ReadReport::unused_position_error.
void place_origin(std::span<const double> coordinates, std::span<const std::uint32_t> corners,
                  Imported& imported);

}  // namespace deltamesh
