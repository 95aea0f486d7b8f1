// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Surfaces in the cubes of a grid for `core`: the module `grid` reads them.
#include "grid/grid.h"
#include "part.h"

namespace deltamesh {
namespace web {

DELTAMESH_OF_PART(grid, read_grid)
Result<GridMesh> read_grid_there(const GridChunks& chunks, const PredictiveParameters& parameters,
                                 std::uint32_t vertices, std::uint32_t triangles);

}  // namespace web

Result<GridMesh> read_grid(const GridChunks& chunks, const PredictiveParameters& parameters,
                           std::uint32_t vertices, std::uint32_t triangles,
                           const Learning<GridModels>& /*none*/, const KnownMesh* /*none*/) {
  return web::read_grid_there(chunks, parameters, vertices, triangles);
}

}  // namespace deltamesh
