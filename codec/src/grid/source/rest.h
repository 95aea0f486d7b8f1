// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Faces of a mesh that lie in no cube, and vertices that no face in a cube has. Encoder only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "connectivity/faces/faces.h"
#include "entropy/coder/writer.h"
#include "grid/grid.h"
#include "grid/rest/rest.h"
#include "grid/source/cubes.h"

namespace deltamesh::grid {

class SourceRest {
 public:
  /// `triangles`: m x 3, of `vertex_count` vertices. O(n + m).
  SourceRest(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count, const SourceCubes& source);

  RestSize size() const noexcept {
    return {.vertices = static_cast<std::uint32_t>(vertices_.size()),
            .triangles = static_cast<std::uint32_t>(faces_.size())};
  }

  /// Codes it behind `surface`, whose vertices have `surface_cells`, and adds it to `coded`. `cells`: of all
  /// vertices. O(n' + m' log m').
  void write(CompactWriter& writer, RestModels& models, const VertexFinder& finder,
             std::span<const Cell> cells, const PredictiveParameters& parameters, CodedGrid& coded);

 private:
  void sort_faces(std::span<const std::uint32_t> numbers);
  CodedConnectivity write_faces(std::size_t vertex_count) const;

  std::span<const std::uint32_t> triangles_;
  std::vector<std::uint32_t> faces_;     ///< of the mesh
  std::vector<std::uint32_t> vertices_;  ///< of the mesh, ascending
};

}  // namespace deltamesh::grid
