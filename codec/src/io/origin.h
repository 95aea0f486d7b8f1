// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Where a mesh keeps its origin: the one rule all importers share.
#pragma once

#include <array>
#include <span>
#include <vector>

namespace deltamesh {

struct PlacedPositions {
  std::array<double, 3> origin{};
  std::vector<float> positions;  ///< n x 3, relative to `origin`
};

/// Splits `coordinates` (n x 3, model units) into an origin and local float32 positions. An axis gets an
/// origin other than 0 only where the centre of the bounding box is farther from 0 than 4 times its longest
/// side; that origin is the centre as a float32, and a whole number where the longest side exceeds 2. NaN and
/// infinities stay what they are and do not count for the box. Cost O(n).
PlacedPositions place_origin(std::span<const double> coordinates);

}  // namespace deltamesh
