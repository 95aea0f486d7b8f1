// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The faces and positions of a stream whose GRID chunk has both.
#pragma once

#include <cstdint>
#include <vector>

#include "deltamesh/result.h"
#include "format/container.h"

namespace deltamesh {

struct GridSurface {
  std::vector<std::uint32_t> triangles;  ///< m x 3 geometric vertices
  std::vector<float> positions;          ///< n x 3, of these
};

/// Precondition: is_of_grid(container), whose counts the caller has checked against its limits. Errors:
/// kTruncated, kInvalidStream [GRD-*, CONN-*, POSN-*, GEO-1].
Result<GridSurface> read_grid_surface(const Container& container);

}  // namespace deltamesh
