// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <memory>

#include "entropy/coder/writer.h"
#include "grid/bounds.h"
#include "grid/grid.h"
#include "grid/growth.h"
#include "grid/places.h"
#include "grid/source/cubes.h"

namespace deltamesh {
namespace {

/// Faces and vertices of `source` in the order in which they were coded.
CodedGrid in_coded_order(const grid::Surface& surface, const grid::SourceCubes& source,
                         std::span<const std::uint32_t> triangles) {
  CodedGrid coded;
  coded.left_faces = source.left_faces();
  coded.vertex_order.resize(surface.vertex_count);
  coded.triangles.reserve(3 * surface.triangles.size());
  coded.face_order.reserve(surface.triangles.size());
  coded.face_rotation.reserve(surface.triangles.size());
  for (const std::uint32_t cube : surface.cubes) {
    for (const auto& face : source.faces(cube)) {
      const auto& vertices = surface.triangles[coded.face_order.size()];
      coded.triangles.insert(coded.triangles.end(), vertices.begin(), vertices.end());
      for (std::size_t c = 0; c < 3; ++c)
        coded.vertex_order[vertices[c]] = triangles[3 * std::size_t{face.face} + (face.turn + c) % 3];
      coded.face_order.push_back(face.face);
      coded.face_rotation.push_back(face.turn);
    }
  }
  return coded;
}

}  // namespace

CodedGrid write_grid(std::span<const std::uint32_t> triangles, std::span<const Cell> cells,
                     const PredictiveParameters& parameters) {
  const auto faces = static_cast<std::uint32_t>(triangles.size() / 3);
  const auto limits = grid::limits_of(parameters, static_cast<std::uint32_t>(cells.size()), faces);
  const grid::SourceCubes source(triangles, cells, parameters.levels, limits.bricks);
  CompactWriter writer;
  writer.reserve(6 * cells.size());
  const auto models = std::make_unique<grid::GrowthModels>();
  grid::Surface surface;
  grid::Growth(writer, *models, source, limits, surface).grow();
  CodedGrid coded = in_coded_order(surface, source, triangles);
  std::vector<Cell> in_order;
  in_order.reserve(surface.vertex_count);
  for (const std::uint32_t v : coded.vertex_order) in_order.push_back(cells[v]);
  grid::PlaceModels place_models(parameters.levels);
  grid::PlaceCoder(writer, place_models, parameters.levels, surface, parameters.lattice.cells).code(in_order);
  coded.payload = writer.finish();
  return coded;
}

}  // namespace deltamesh
