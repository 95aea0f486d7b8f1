// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "base/broken_rule.h"
#include "base/memory/large_vector.h"
#include "base/try.h"
#include "connectivity/faces/faces.h"
#include "entropy/coder/reader.h"
#include "format/chunk/tags.h"
#include "format/vertex_positions.h"
#include "grid/bounds.h"
#include "grid/grid.h"
#include "grid/grid_models.h"
#include "grid/growth.h"
#include "grid/places.h"
#include "grid/rest/rest.h"
#include "positions/ordered_read.h"

namespace deltamesh {
namespace {

/// A reader has none.
struct NoSource {};

Error broken(const char* rule) noexcept {
  return broken_rule("a surface that does not fit its grid", rule, kTagGrid);
}

/// False where one is beyond the lattice.
bool place_inner(const grid::Surface& surface, const PredictiveParameters& parameters,
                 std::span<Cell> cells) {
  for (const grid::InnerVertex& inner : surface.inner) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::int64_t node = std::int64_t{inner.brick[axis]} * grid::kSide + inner.spot[axis];
      const std::int64_t at = node * 2 * parameters.levels + inner.offset[axis];
      if (at < 0 || at > parameters.lattice.cells[axis]) return false;
      cells[inner.vertex][axis] = static_cast<std::int32_t>(at);
    }
  }
  return true;
}

/// Faces in cubes, and their vertices. Null, or the rule that a stream breaks.
const char* read_surface(CompactReader& reader, const PredictiveParameters& parameters,
                         const grid::Limits& limits, GridModels& models, const grid::KnownSurface* known,
                         grid::Surface& surface, LargeVector<Cell>& cells) {
  grid::KnownGrowth known_growth(known);
  const char* rule = grid::Growth(reader, models.growth, NoSource{}, limits, surface, known_growth).grow();
  if (rule != nullptr || reader.failed()) return rule;
  surface.bricks.free_cubes();
  cells.resize(surface.vertex_count);
  const auto known_places =
      std::make_unique<grid::KnownPlaces>(known, grid::PlaceModels::symbols(parameters.levels));
  rule = grid::PlaceCoder(reader, models.places, parameters.levels, surface, parameters.lattice.cells,
                          *known_places)
             .code(cells);
  if (rule != nullptr || reader.failed()) return rule;
  return place_inner(surface, parameters, cells) ? nullptr : "GRD-9";
}

/// A mesh on the lattice.
struct GridCells {
  LargeVector<std::array<std::uint32_t, 3>> triangles;
  LargeVector<Cell> cells;  ///< of the vertices
};

/// Adds the faces in no cube, and the vertices that only they have. `triangles`: over those of the rest.
Result<void> add_rest(CompactReader& reader, std::span<const std::uint32_t> triangles,
                      const grid::RestSize& size, grid::RestModels& models, const grid::Surface& surface,
                      const PredictiveParameters& parameters, GridCells& mesh) {
  const KnownFaces faces({triangles, size.vertices});
  std::vector<std::uint32_t> numbers(size.vertices);
  std::vector<Cell> cells(size.vertices);
  const grid::VertexFinder finder(surface, mesh.cells, parameters.levels);
  const char* const rule =
      grid::RestCoder(reader, models, faces, finder, parameters.lattice.cells).code({}, numbers, cells);
  if (reader.failed()) return {};
  if (rule != nullptr) return broken(rule);
  const std::size_t of_surface = mesh.cells.size();
  for (std::size_t v = 0; v < numbers.size(); ++v)
    if (numbers[v] >= of_surface) mesh.cells.push_back(cells[v]);
  for (std::size_t i = 0; i < triangles.size(); i += 3)
    mesh.triangles.push_back({numbers[triangles[i]], numbers[triangles[i + 1]], numbers[triangles[i + 2]]});
  return {};
}

Result<GridCells> read_cells(const GridChunks& chunks, const PredictiveParameters& parameters,
                             grid::Limits& limits, GridModels& models, const grid::KnownSurface* known) {
  const auto& [surface_bytes, rest_faces] = chunks;
  CompactReader reader(surface_bytes);
  grid::RestModels rest_models;
  grid::RestSize size;
  code_rest_size(reader, size, rest_models);
  // Every vertex of the rest is a face's, or is not the surface's.
  const bool is_too_large = size.triangles > limits.triangles ||
                            size.vertices > std::uint64_t{3} * size.triangles + limits.vertices;
  if (is_too_large && !reader.failed()) return broken("GRD-8");
  if (size.vertices == 0 && (size.triangles > 0 || !rest_faces.empty()) && !reader.failed())
    return broken("GRD-11");
  GridCells mesh;
  grid::Surface surface;
  if (!reader.failed()) {
    // The usual share of a byte is far less; what comes beyond that moves.
    const auto likely = [bytes = surface_bytes.size()](std::size_t most) {
      return std::min(most / 16 + 1, bytes) * 16;
    };
    // With those of the rest, which are added in the end.
    surface.triangles.reserve(likely(limits.triangles));
    mesh.cells.reserve(likely(limits.vertices));
    surface.bricks.reserve(likely(limits.vertices));
    limits.triangles -= size.triangles;
    const char* const rule = read_surface(reader, parameters, limits, models, known, surface, mesh.cells);
    if (rule != nullptr && !reader.failed()) return broken(rule);
  }
  mesh.triangles = surface.triangles.take();
  if (size.vertices > 0 && !reader.failed()) {
    DELTAMESH_TRY(const auto faces, read_connectivity(rest_faces, size.vertices, size.triangles));
    DELTAMESH_CHECK(add_rest(reader, faces.triangles, size, rest_models, surface, parameters, mesh));
  }
  DELTAMESH_CHECK(reader.finish(kTagGrid));
  return mesh;
}

}  // namespace

Result<GridMesh> read_grid(const GridChunks& chunks, const PredictiveParameters& parameters,
                           std::uint32_t vertices, std::uint32_t triangles,
                           const Learning<GridModels>& learning, const KnownMesh* known) {
  auto limits =
      grid::limits_of(parameters, vertices, triangles, known != nullptr ? known->positions.size() / 3 : 0);
  if (!grid::are_few(limits.bricks)) return broken("GRD-1");
  std::optional<grid::KnownSurface> surface;
  if (known != nullptr) {
    surface = grid::KnownSurface::make(*known, parameters);
    if (!surface) return broken("MAP-27");
  }
  const auto models = GridModels::begin(parameters.levels, learning.start);
  DELTAMESH_TRY(const auto read,
                read_cells(chunks, parameters, limits, *models, surface ? &*surface : nullptr));
  if (read.cells.size() != vertices || read.triangles.size() != triangles) return broken("GRD-8");
  GridMesh mesh;
  reserve_large(mesh.triangles, 3 * read.triangles.size());
  for (const auto& triangle : read.triangles)
    mesh.triangles.insert(mesh.triangles.end(), triangle.begin(), triangle.end());
  mesh.positions = to_rows(read.cells, parameters.lattice);
  DELTAMESH_CHECK(check_finite(mesh.positions));
  if (surface) mesh.known = surface->vertices_at(mesh.positions, parameters);
  if (learning.end != nullptr) *learning.end = std::move(*models);
  return mesh;
}

}  // namespace deltamesh
