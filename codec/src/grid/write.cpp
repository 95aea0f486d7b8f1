// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <memory>
#include <utility>

#include "entropy/coder/writer.h"
#include "grid/bounds.h"
#include "grid/grid.h"
#include "grid/grid_models.h"
#include "grid/growth.h"
#include "grid/places.h"
#include "grid/source/cubes.h"
#include "grid/source/rest.h"
#include "positions/ordered_read.h"

namespace deltamesh {
namespace {

/// Faces and vertices of `source` in the order in which they were coded.
CodedGrid in_coded_order(const grid::Surface& surface, const grid::SourceCubes& source,
                         std::span<const std::uint32_t> triangles) {
  CodedGrid coded;
  coded.vertex_order.resize(surface.vertex_count);
  coded.triangles.reserve(triangles.size());
  coded.face_order.reserve(triangles.size() / 3);
  coded.face_rotation.reserve(triangles.size() / 3);
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

std::vector<Cell> in_order(std::span<const Cell> cells, std::span<const std::uint32_t> order) {
  std::vector<Cell> ordered;
  ordered.reserve(order.size());
  for (const std::uint32_t v : order) ordered.push_back(cells[v]);
  return ordered;
}

}  // namespace

std::optional<CodedGrid> write_grid(std::span<const std::uint32_t> triangles, std::span<const Cell> cells,
                                    const PredictiveParameters& parameters, const GridModels* start,
                                    const KnownMesh* known) {
  const auto limits = grid::limits_of(parameters, static_cast<std::uint32_t>(cells.size()),
                                      static_cast<std::uint32_t>(triangles.size() / 3),
                                      known != nullptr ? known->positions.size() / 3 : 0);
  if (!grid::are_few(limits.bricks)) return std::nullopt;
  const grid::SourceCubes source(triangles, cells, parameters.levels, limits.bricks);
  // Then other coders take fewer bytes.
  if (4 * source.left_faces().size() > triangles.size()) return std::nullopt;
  grid::SourceRest rest(triangles, static_cast<std::uint32_t>(cells.size()), source);
  std::optional<grid::KnownSurface> known_surface;
  if (known != nullptr) {
    known_surface = grid::KnownSurface::make(*known, parameters);
    if (!known_surface) return std::nullopt;
  }
  const grid::KnownSurface* const beside = known_surface ? &*known_surface : nullptr;
  CompactWriter writer;
  writer.reserve(6 * cells.size());
  grid::RestModels rest_models;
  grid::RestSize rest_size = rest.size();
  code_rest_size(writer, rest_size, rest_models);
  const auto models = GridModels::begin(parameters.levels, start);
  grid::Surface surface;
  grid::KnownGrowth known_growth(beside);
  if (grid::Growth(writer, models->growth, source, limits, surface, known_growth).grow() != nullptr)
    return std::nullopt;
  CodedGrid coded = in_coded_order(surface, source, triangles);
  std::vector<Cell> surface_cells = in_order(cells, coded.vertex_order);
  const auto known_places =
      std::make_unique<grid::KnownPlaces>(beside, grid::PlaceModels::symbols(parameters.levels));
  grid::PlaceCoder(writer, models->places, parameters.levels, surface, parameters.lattice.cells,
                   *known_places)
      .code(surface_cells);
  if (rest_size.vertices > 0)
    rest.write(writer, rest_models, {surface, surface_cells, parameters.levels}, cells, parameters, coded);
  coded.payloads.surface = writer.finish();
  if (beside != nullptr) {
    std::vector<Cell> coded_cells = in_order(cells, coded.vertex_order);
    std::copy(surface_cells.begin(), surface_cells.end(), coded_cells.begin());
    coded.known = beside->vertices_at(to_rows(coded_cells, parameters.lattice), parameters);
  }
  coded.surface_cells = std::move(surface_cells);
  return coded;
}

}  // namespace deltamesh
