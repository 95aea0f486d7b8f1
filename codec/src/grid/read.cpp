// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <memory>

#include "base/broken_rule.h"
#include "base/try.h"
#include "entropy/coder/reader.h"
#include "format/chunk/tags.h"
#include "grid/bounds.h"
#include "grid/grid.h"
#include "grid/growth.h"
#include "grid/places.h"
#include "grid/rest/rest.h"

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
                         const grid::Limits& limits, grid::Surface& surface, LargeVector<Cell>& cells) {
  const auto models = std::make_unique<grid::GrowthModels>();
  const char* rule = grid::Growth(reader, *models, NoSource{}, limits, surface).grow();
  if (rule != nullptr || reader.failed()) return rule;
  cells.resize(surface.vertex_count);
  grid::PlaceModels place_models(parameters.levels);
  rule = grid::PlaceCoder(reader, place_models, parameters.levels, surface, parameters.lattice.cells)
             .code(cells);
  if (rule != nullptr || reader.failed()) return rule;
  return place_inner(surface, parameters, cells) ? nullptr : "GRD-9";
}

/// Adds the faces in no cube, and the vertices that only they have.
Result<void> read_rest(CompactReader& reader, const grid::RestPayloads& payloads, grid::RestModels& models,
                       const PredictiveParameters& parameters, const grid::Surface& surface,
                       std::uint32_t most_vertices, GridMesh& mesh) {
  DELTAMESH_TRY(const grid::RestMesh rest, grid::read_rest(payloads, parameters.lattice));
  const std::uint32_t own = surface.vertex_count;
  const grid::VertexFinder finder(surface, mesh.cells, parameters.levels);
  std::vector<std::uint32_t> numbers;
  if (!code_shared(reader, rest.cells, finder, own, numbers, models)) return broken("GRD-11");
  std::size_t added = 0;
  for (const std::uint32_t number : numbers) added += number >= own ? 1 : 0;
  if (added > most_vertices - own) return broken("GRD-8");
  mesh.cells.resize(own + added);
  for (std::size_t v = 0; v < numbers.size(); ++v) mesh.cells[numbers[v]] = rest.cells[v];
  for (std::size_t i = 0; i < rest.triangles.size(); i += 3)
    mesh.triangles.push_back(
        {numbers[rest.triangles[i]], numbers[rest.triangles[i + 1]], numbers[rest.triangles[i + 2]]});
  return {};
}

}  // namespace

Result<GridMesh> read_grid(const GridPayloads& payloads, const PredictiveParameters& parameters,
                           std::uint32_t most_vertices, std::uint32_t most_triangles) {
  auto limits = grid::limits_of(parameters, most_vertices, most_triangles);
  if (!grid::are_few(limits.bricks)) return broken("GRD-1");
  CompactReader reader(payloads.surface);
  grid::RestModels rest_models;
  grid::RestPayloads rest;
  code_rest_size(reader, rest, rest_models);
  // Every vertex of the rest is a face's, or is not the surface's.
  const bool is_too_large =
      rest.triangles > most_triangles || rest.vertices > std::uint64_t{3} * rest.triangles + most_vertices;
  if (is_too_large && !reader.failed()) return broken("GRD-8");
  const bool has_rest = !payloads.rest_faces.empty() || !payloads.rest_positions.empty();
  if (rest.vertices == 0 && (rest.triangles > 0 || has_rest) && !reader.failed()) return broken("GRD-11");
  GridMesh mesh;
  grid::Surface surface;
  if (!reader.failed()) {
    limits.triangles -= rest.triangles;
    // The usual share of a byte is far less; what comes beyond that moves.
    const auto likely = [&](std::size_t most) { return std::min(most / 16, payloads.surface.size()) * 16; };
    surface.triangles.reserve(likely(limits.triangles));
    surface.bricks.reserve(likely(limits.vertices));
    const char* const rule = read_surface(reader, parameters, limits, surface, mesh.cells);
    if (rule != nullptr && !reader.failed()) return broken(rule);
  }
  mesh.triangles = surface.triangles.take();
  if (rest.vertices > 0 && !reader.failed()) {
    rest.faces = payloads.rest_faces;
    rest.positions = payloads.rest_positions;
    DELTAMESH_CHECK(read_rest(reader, rest, rest_models, parameters, surface, most_vertices, mesh));
  }
  DELTAMESH_CHECK(reader.finish(kTagGrid));
  return mesh;
}

}  // namespace deltamesh
