// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <memory>

#include "connectivity/faces/faces.h"
#include "entropy/coder/writer.h"
#include "grid/bounds.h"
#include "grid/grid.h"
#include "grid/growth.h"
#include "grid/places.h"
#include "grid/rest/rest.h"
#include "grid/source/cubes.h"
#include "positions/positions.h"

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

/// Faces in no cube, and vertices that no face in a cube has.
class Rest {
 public:
  Rest(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count, const grid::SourceCubes& source)
      : faces_(source.left_faces()) {
    std::vector<bool> is_left(triangles.size() / 3);
    for (const std::uint32_t face : faces_) is_left[face] = true;
    std::vector<bool> is_own(vertex_count, true);
    for (std::size_t i = 0; i < triangles.size(); ++i)
      if (!is_left[i / 3]) is_own[triangles[i]] = false;
    for (const std::uint32_t face : faces_)
      for (std::size_t c = 0; c < 3; ++c) is_own[triangles[3 * std::size_t{face} + c]] = true;
    std::vector<std::uint32_t> local(vertex_count);
    for (std::uint32_t v = 0; v < vertex_count; ++v) {
      if (!is_own[v]) continue;
      local[v] = static_cast<std::uint32_t>(vertices_.size());
      vertices_.push_back(v);
    }
    std::vector<std::uint32_t> corners;
    corners.reserve(3 * faces_.size());
    for (const std::uint32_t face : faces_)
      for (std::size_t c = 0; c < 3; ++c) corners.push_back(local[triangles[3 * std::size_t{face} + c]]);
    coded_ = write_connectivity(corners, static_cast<std::uint32_t>(vertices_.size()));
    for (std::uint32_t& v : coded_.vertex_order) v = vertices_[v];
  }

  std::uint32_t vertex_count() const noexcept { return static_cast<std::uint32_t>(vertices_.size()); }
  std::uint32_t face_count() const noexcept { return static_cast<std::uint32_t>(faces_.size()); }
  /// Input vertex of every coded one.
  const std::vector<std::uint32_t>& vertices() const noexcept { return coded_.vertex_order; }

  void write(std::span<const Cell> cells, const PositionLattice& lattice, GridPayloads& payloads) const {
    payloads.rest_faces = coded_.payload;
    payloads.rest_positions =
        write_positions({coded_.triangles, vertex_count()}, cells, {.lattice = lattice});
  }

  /// `numbers`: of its vertices, in the whole mesh.
  void add_to(CodedGrid& grid, std::span<const std::uint32_t> numbers) const {
    for (std::size_t v = 0; v < numbers.size(); ++v)
      if (numbers[v] >= grid.vertex_order.size()) grid.vertex_order.push_back(coded_.vertex_order[v]);
    for (const std::uint32_t v : coded_.triangles) grid.triangles.push_back(numbers[v]);
    for (const std::uint32_t face : coded_.face_order) grid.face_order.push_back(faces_[face]);
    grid.face_rotation.insert(grid.face_rotation.end(), coded_.face_rotation.begin(),
                              coded_.face_rotation.end());
    grid.rest_triangles = face_count();
  }

 private:
  const std::vector<std::uint32_t>& faces_;
  std::vector<std::uint32_t> vertices_;
  CodedConnectivity coded_;
};

std::vector<Cell> in_order(std::span<const Cell> cells, std::span<const std::uint32_t> order) {
  std::vector<Cell> ordered;
  ordered.reserve(order.size());
  for (const std::uint32_t v : order) ordered.push_back(cells[v]);
  return ordered;
}

/// In the whole mesh: the surface's vertices as they are, then the rest's own.
std::vector<std::uint32_t> numbers_of(std::span<const std::uint32_t> rest,
                                      std::span<const std::uint32_t> surface_vertices, std::size_t all) {
  std::vector<std::uint32_t> of_surface(all, grid::kNoVertex);
  for (std::uint32_t v = 0; v < surface_vertices.size(); ++v) of_surface[surface_vertices[v]] = v;
  auto next = static_cast<std::uint32_t>(surface_vertices.size());
  std::vector<std::uint32_t> numbers;
  for (const std::uint32_t v : rest)
    numbers.push_back(of_surface[v] != grid::kNoVertex ? of_surface[v] : next++);
  return numbers;
}

}  // namespace

std::optional<CodedGrid> write_grid(std::span<const std::uint32_t> triangles, std::span<const Cell> cells,
                                    const PredictiveParameters& parameters) {
  const auto limits = grid::limits_of(parameters, static_cast<std::uint32_t>(cells.size()),
                                      static_cast<std::uint32_t>(triangles.size() / 3));
  if (!grid::are_few(limits.bricks)) return std::nullopt;
  const grid::SourceCubes source(triangles, cells, parameters.levels, limits.bricks);
  // Then other coders take fewer bytes.
  if (4 * source.left_faces().size() > triangles.size()) return std::nullopt;
  const Rest rest(triangles, static_cast<std::uint32_t>(cells.size()), source);
  const auto& most = parameters.lattice.cells;
  if (rest.vertex_count() > 0 && std::max({most[0], most[1], most[2]}) > grid::kMostRestCells)
    return std::nullopt;

  CompactWriter writer;
  writer.reserve(6 * cells.size());
  grid::RestModels rest_models;
  grid::RestSize rest_size{.vertices = rest.vertex_count(), .triangles = rest.face_count()};
  code_rest_size(writer, rest_size, rest_models);
  const auto models = std::make_unique<grid::GrowthModels>();
  grid::Surface surface;
  if (grid::Growth(writer, *models, source, limits, surface).grow() != nullptr) return std::nullopt;
  CodedGrid coded = in_coded_order(surface, source, triangles);
  std::vector<Cell> surface_cells = in_order(cells, coded.vertex_order);
  grid::PlaceModels place_models(parameters.levels);
  grid::PlaceCoder(writer, place_models, parameters.levels, surface, most).code(surface_cells);
  if (rest.vertex_count() > 0) {
    const std::vector<Cell> rest_cells = in_order(cells, rest.vertices());
    auto numbers = numbers_of(rest.vertices(), coded.vertex_order, cells.size());
    const grid::VertexFinder finder(surface, surface_cells, parameters.levels);
    if (!code_shared(writer, rest_cells, finder, surface.vertex_count, numbers, rest_models))
      return std::nullopt;
    rest.write(rest_cells, parameters.lattice, coded.payloads);
    rest.add_to(coded, numbers);
  }
  coded.payloads.surface = writer.finish();
  return coded;
}

}  // namespace deltamesh
