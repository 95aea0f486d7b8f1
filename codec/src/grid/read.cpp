// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <memory>

#include "base/broken_rule.h"
#include "base/try.h"
#include "entropy/coder/reader.h"
#include "format/chunk/tags.h"
#include "grid/bounds.h"
#include "grid/grid.h"
#include "grid/growth.h"
#include "grid/places.h"

namespace deltamesh {
namespace {

/// A reader has none.
struct NoSource {};

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

}  // namespace

bool fits_grid_coder(const PredictiveParameters& parameters) noexcept {
  const auto bricks = grid::limits_of(parameters, 0, 0).bricks;
  return std::uint64_t{bricks[0]} * bricks[1] < (std::uint64_t{1} << 32) / bricks[2];
}

Result<GridMesh> read_grid(std::span<const std::byte> payload, const PredictiveParameters& parameters,
                           std::uint32_t most_vertices, std::uint32_t most_triangles) {
  const auto broken = [](const char* rule) {
    return broken_rule("a surface that does not fit its grid", rule, kTagPositions);
  };
  if (!fits_grid_coder(parameters)) return broken("GRD-1");
  const auto limits = grid::limits_of(parameters, most_vertices, most_triangles);
  CompactReader reader(payload);
  const auto models = std::make_unique<grid::GrowthModels>();
  grid::Surface surface;
  if (const char* rule = grid::Growth(reader, *models, NoSource{}, limits, surface).grow()) {
    if (!reader.failed()) return broken(rule);
  }
  GridMesh mesh;
  if (!reader.failed()) {
    mesh.cells.resize(surface.vertex_count);
    grid::PlaceModels place_models(parameters.levels);
    grid::PlaceCoder places(reader, place_models, parameters.levels, surface, parameters.lattice.cells);
    const char* rule = places.code(mesh.cells);
    if (rule != nullptr && !reader.failed()) return broken(rule);
  }
  DELTAMESH_CHECK(reader.finish(kTagPositions));
  if (!place_inner(surface, parameters, mesh.cells)) return broken("GRD-8");
  mesh.triangles = surface.triangles.take();
  return mesh;
}

}  // namespace deltamesh
