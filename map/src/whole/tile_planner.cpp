// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <map>
#include <utility>

#include "base/guard.h"
#include "base/try.h"
#include "deltamesh/color_content.h"
#include "deltamesh/find_grid.h"
#include "deltamesh/map/tiles.h"
#include "part/view_cells.h"
#include "split/octree.h"
#include "split/stored_block.h"
#include "support/errors.h"
#include "whole/describe.h"

namespace deltamesh {

/// Where a mesh is.
struct MeshReach {
  Box box;
  double overhang = 0;  ///< how far faces reach out of their cells, along an axis
};

namespace {

MeshReach reach_of(const Mesh& mesh, const StoredBlocks& blocks, const MapDescription& description) {
  MeshReach reach{.box = box_of(mesh.positions)};
  for (const auto& [cell, block] : blocks) {
    const CellCube cube = cube_of(key_of(cell), description);
    const Box box = box_of(block.mesh.positions);
    for (std::size_t k = 0; k < 3; ++k)
      reach.overhang =
          std::max({reach.overhang, cube.low[k] - box.min[k], box.max[k] - (cube.low[k] + cube.edge)});
  }
  return reach;
}

bool touches(const Box& box, const CellCube& cell, double margin) noexcept {
  for (std::size_t k = 0; k < 3; ++k)
    if (box.min[k] > cell.low[k] + cell.edge + margin || box.max[k] < cell.low[k] - margin) return false;
  return true;
}

}  // namespace

struct TilePlanner::State {
  MapSettings settings;
  std::uint64_t tile_triangles = 0;
  MapDescription description{};
  std::vector<MeshReach> reaches{};     ///< of every mesh
  std::vector<std::uint64_t> hashes{};  ///< likewise
  Octree octree{};
  ColorContent colors{};

  /// Faces in the tile come from meshes that touch it; what has positions at the same lattice points touches
  /// these faces.
  std::vector<std::uint32_t> meshes_of(const PartKey& cell) const {
    const CellCube cube = cube_of(cell, description);
    double overhang = 0;
    for (const MeshReach& reach : reaches)
      if (touches(reach.box, cube, reach.overhang)) overhang = std::max(overhang, reach.overhang);
    std::vector<std::uint32_t> meshes;
    for (std::uint32_t i = 0; i < reaches.size(); ++i)
      if (touches(reaches[i].box, cube, overhang + description.lattice.step())) meshes.push_back(i);
    return meshes;
  }
};

TilePlanner::TilePlanner(std::unique_ptr<State> state) noexcept : state_(std::move(state)) {}
TilePlanner::TilePlanner(TilePlanner&&) noexcept = default;
TilePlanner& TilePlanner::operator=(TilePlanner&&) noexcept = default;
TilePlanner::~TilePlanner() = default;

Result<TilePlanner> TilePlanner::make(const MapSettings& settings, std::uint64_t tile_triangles) noexcept {
  return guarded([&]() -> Result<TilePlanner> {
    DELTAMESH_CHECK(validate(settings));
    const QualityRequest& bounds = settings.quality.bounds;
    if (bounds.empty()) return invalid_argument("tiles need a bound on positions, such as a largest error");
    for (const auto& bound : {bounds.vde, bounds.lfe, bounds.max_error})
      if (bound && bound->unit != QualityUnit::kModel)
        return invalid_argument(
            "bounds of tiles are in model units: no tile knows the diagonal of the whole map");
    if (settings.levels != 0) return invalid_argument("tiles have no coarser levels");
    if (tile_triangles < settings.most_triangles)
      return invalid_argument("tiles of fewer triangles than their parts may have");
    auto state = std::make_unique<State>();
    state->settings = settings;
    state->tile_triangles = tile_triangles;
    return TilePlanner(std::move(state));
  });
}

Result<void> TilePlanner::add(const MeshView& mesh) noexcept {
  return guarded([&]() -> Result<void> {
    State& state = *state_;
    MapDescription description = state.description;
    if (state.reaches.empty()) {
      DELTAMESH_TRY(description,
                    describe_map(mesh, find_grid(mesh), state.settings, state.settings.quality.bounds, 0));
    }
    DELTAMESH_TRY(Mesh moved, to_map(mesh, description));
    const StoredBlock whole = store_block(std::move(moved));
    DELTAMESH_CHECK(state.colors.add(mesh));
    const StoredBlocks blocks = blocks_of(whole.mesh, description);
    for (const auto& [cell, block] : blocks) state.octree.add(cell, block.mesh.triangle_count());
    state.reaches.push_back(reach_of(whole.mesh, blocks, description));
    state.description = std::move(description);
    state.hashes.push_back(whole.hash);
    return {};
  });
}

Result<TilePlan> TilePlanner::plan() const noexcept {
  return guarded([&]() -> Result<TilePlan> {
    const State& state = *state_;
    if (state.reaches.empty()) return invalid_argument("no meshes to plan tiles of");
    TilePlan plan{.description = state.description, .quality = state.settings.quality};
    plan.quality.attributes = state.colors.complete(std::move(plan.quality.attributes));
    plan.mesh_hashes = state.hashes;
    const PartSize part{state.settings.most_triangles, kLevelsOfParts};
    const PartSize tile{state.tile_triangles, kMostPartLevel};
    std::map<PartKey, std::uint64_t> triangles;  // of tiles
    for (const auto& [cell, count] : state.octree.cells()) {
      plan.parts.push_back(state.octree.part_of(cell, part));
      triangles[state.octree.part_of(cell, tile)] += count;
    }
    std::ranges::sort(plan.parts);
    plan.parts.erase(std::unique(plan.parts.begin(), plan.parts.end()), plan.parts.end());
    for (const auto& [cell, count] : triangles) plan.tiles.push_back({cell, count, state.meshes_of(cell)});
    return plan;
  });
}

}  // namespace deltamesh
