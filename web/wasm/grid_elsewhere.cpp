// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Surfaces in the cubes of a grid for `core`: the module `grid` reads them.
#include "base/try.h"
#include "grid/grid.h"
#include "parts.h"

namespace deltamesh {

Result<GridMesh> read_grid(const GridChunks& chunks, const PredictiveParameters& parameters,
                           std::uint32_t vertices, std::uint32_t triangles,
                           const Learning<GridModels>& /*none*/, const KnownMesh* /*none*/) {
  constexpr auto kPart = web::Part::kGrid;
  web::GridCall call{.parameters = parameters, .vertices = vertices, .triangles = triangles};
  for (std::size_t k = 0; k < chunks.size(); ++k) call.chunks[k] = web::hand_over(kPart, chunks[k]);
  DELTAMESH_TRY(const auto returned, web::call_part(kPart, call));
  GridMesh mesh;
  web::take_array(kPart, returned.arrays[0], mesh.triangles);
  web::take_array(kPart, returned.arrays[1], mesh.positions);
  return mesh;
}

}  // namespace deltamesh
