// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The exports of `grid`, for surfaces in the cubes of a grid.
#include "grid/grid.h"

#include "part.h"

namespace deltamesh::web {

DELTAMESH_EXPORT(read_grid)
Result<GridMesh> read_grid_here(const GridChunks& chunks, const PredictiveParameters& parameters,
                                std::uint32_t vertices, std::uint32_t triangles) {
  return read_grid(chunks, parameters, vertices, triangles);
}

}  // namespace deltamesh::web
