// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The grid coder: a mesh whose faces lie in the cubes of a grid, faces and positions at once [GRD-*].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/memory/large_vector.h"
#include "deltamesh/result.h"
#include "format/predictive_parameters.h"
#include "positions/blend/blend.h"

namespace deltamesh {

struct CodedGrid {
  std::vector<std::byte> payload;
  std::vector<std::uint32_t> triangles;     ///< m x 3: what read_grid() will return
  std::vector<std::uint32_t> vertex_order;  ///< n: input vertex of every coded vertex
  std::vector<std::uint32_t> face_order;    ///< m: input face of every coded face
  std::vector<std::uint8_t> face_rotation;  ///< m: which corner of the input face is the coded one's corner 0
  std::vector<std::uint32_t> left_faces;    ///< input faces that lie in no cube, which are not coded
};

/// Whether a grid of this size can be coded [GRD-1].
bool fits_grid_coder(const PredictiveParameters& parameters) noexcept;

/// The faces of a mesh that lie in cubes, and their vertices. `triangles`: m x 3; `cells`: of its vertices,
/// on the lattice of `parameters`, which are of PositionKind::kVoxel and fit. O(n + m).
CodedGrid write_grid(std::span<const std::uint32_t> triangles, std::span<const Cell> cells,
                     const PredictiveParameters& parameters);

struct GridMesh {
  LargeVector<std::array<std::uint32_t, 3>> triangles;
  LargeVector<Cell> cells;  ///< of the vertices, on the lattice
};

/// A payload of write_grid(), of no more vertices and triangles than the caller allows. Errors: kTruncated,
/// kInvalidStream [GRD-*, CMP-3].
Result<GridMesh> read_grid(std::span<const std::byte> payload, const PredictiveParameters& parameters,
                           std::uint32_t most_vertices, std::uint32_t most_triangles);

}  // namespace deltamesh
