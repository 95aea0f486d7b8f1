// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The grid coder: a mesh most of whose faces lie in the cubes of a grid, faces and positions at once [GRD-*].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "deltamesh/known_mesh.h"
#include "deltamesh/result.h"
#include "entropy/coder/learning.h"
#include "format/chunk/tags.h"
#include "format/predictive_parameters.h"
#include "grid/known/vertex.h"
#include "positions/blend/blend.h"

namespace deltamesh {

struct GridModels;

/// Faces that lie in no cube are an ordinary mesh, which is glued to the others.
struct GridPayloads {
  std::vector<std::byte> surface;
  std::vector<std::byte> rest_faces;  ///< as CONN's; empty where there are none

  std::size_t bytes() const noexcept { return surface.size() + rest_faces.size(); }
};

/// Such payloads in their order, whoever has them, and the tags of their chunks.
using GridChunks = std::array<std::span<const std::byte>, 2>;
inline constexpr std::array kGridTags{kTagGrid, kTagConnectivity};
inline GridChunks chunks_of(const GridPayloads& payloads) noexcept {
  return {payloads.surface, payloads.rest_faces};
}

struct CodedGrid {
  GridPayloads payloads;
  std::vector<std::uint32_t> triangles;     ///< m x 3: what read_grid() will return
  std::vector<std::uint32_t> vertex_order;  ///< n: input vertex of every coded vertex
  std::vector<Cell> surface_cells;        ///< of the first vertices, those of faces in cubes: known ones stay
  std::vector<std::uint32_t> face_order;  ///< m: input face of every coded face
  std::vector<std::uint8_t> face_rotation;  ///< m: which corner of the input face is the coded one's corner 0
  std::uint32_t rest_triangles = 0;         ///< of `triangles`, the last ones: those in no cube
  std::vector<std::uint32_t> known;         ///< n, as GridMesh::known
};

/// `triangles`: m x 3; `cells`: of its n vertices, on the lattice of `parameters`, which are of
/// PositionKind::kVoxel. Nothing where the grid is too large [GRD-1], or where most faces lie in no cube.
/// `start`: null for fresh models. `known`: null, or what readers have, of which nothing is coded again.
/// O(n + m log m).
std::optional<CodedGrid> write_grid(std::span<const std::uint32_t> triangles, std::span<const Cell> cells,
                                    const PredictiveParameters& parameters, const GridModels* start = nullptr,
                                    const KnownMesh* known = nullptr);

struct GridMesh {
  std::vector<std::uint32_t> triangles;  ///< m x 3
  std::vector<float> positions;          ///< n x 3
  std::vector<std::uint32_t> known;  ///< n: what is known at each vertex [MAP-30]; empty without a known mesh
};

/// What write_grid() wrote beside `known`, of `vertices` and `triangles` in number. Errors: kTruncated,
/// kInvalidStream [GRD-*, CONN-*, POSN-*, CMP-3, GEO-1].
Result<GridMesh> read_grid(const GridChunks& chunks, const PredictiveParameters& parameters,
                           std::uint32_t vertices, std::uint32_t triangles,
                           const Learning<GridModels>& learning = {}, const KnownMesh* known = nullptr);

}  // namespace deltamesh
