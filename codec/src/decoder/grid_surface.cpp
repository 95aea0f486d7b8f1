// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "decoder/grid_surface.h"

#include <algorithm>

#include "base/broken_rule.h"
#include "base/memory/large_vector.h"
#include "base/try.h"
#include "entropy/expand_chunk.h"
#include "format/vertex_positions.h"
#include "grid/grid.h"
#include "positions/ordered_read.h"

namespace deltamesh {
namespace {

Result<std::vector<std::byte>> copy_of_payload(const Container& container, std::uint32_t tag) {
  DELTAMESH_TRY(const auto chunk, expand_single(container, tag));
  return std::vector<std::byte>(chunk.bytes().begin(), chunk.bytes().end());
}

std::vector<std::uint32_t> to_corners(const LargeVector<std::array<std::uint32_t, 3>>& triangles) {
  std::vector<std::uint32_t> corners;
  reserve_large(corners, 3 * triangles.size());
  for (const auto& triangle : triangles) corners.insert(corners.end(), triangle.begin(), triangle.end());
  return corners;
}

}  // namespace

Result<GridSurface> read_grid_surface(const Container& container) {
  const FileHeader& header = container.header();
  GridPayloads payloads;
  DELTAMESH_TRY(payloads.surface, copy_of_payload(container, kTagGrid));
  DELTAMESH_TRY(payloads.rest_faces, copy_of_payload(container, kTagConnectivity));
  DELTAMESH_TRY(payloads.rest_positions, copy_of_payload(container, kTagPositions));
  GridSurface surface;
  DELTAMESH_TRY(const GridMesh mesh,
                read_grid(payloads, header.predictive, header.geometric_vertices, header.triangles));
  if (mesh.cells.size() != header.geometric_vertices || mesh.triangles.size() != header.triangles)
    return broken_rule("fewer vertices or faces than the header says", "GRD-8", kTagGrid);
  surface.triangles = to_corners(mesh.triangles);
  surface.positions = to_rows(mesh.cells, header.predictive.lattice);
  DELTAMESH_CHECK(check_finite(surface.positions));
  return surface;
}

}  // namespace deltamesh
