// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A stream's surface in the cubes of a grid.
#pragma once

#include "format/container.h"
#include "grid/grid.h"

namespace deltamesh {

/// What GRID, CONN and POSN hold together [GRD-*]. Errors: as read_grid() and expand_single().
Result<GridMesh> read_grid_chunks(const Container& container, const Learning<GridModels>& learning);

}  // namespace deltamesh
