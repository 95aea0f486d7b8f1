// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/map/block_adapter.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "adapt/attributes.h"
#include "adapt/known_positions.h"
#include "base/guard.h"
#include "base/try.h"
#include "connectivity/check_mesh.h"
#include "split/assemble.h"
#include "split/stored_block.h"
#include "support/at_block.h"
#include "support/errors.h"
#include "support/row_gather.h"

namespace deltamesh {

struct BlockAdapter::State {
  State(MapDescription d, double tolerance)
      : description(std::move(d)), positions(tolerance, description.lattice.step()) {}

  Mesh settled(Mesh mesh, std::vector<KnownPositions::Position>& to);

  MapDescription description;
  KnownPositions positions;
  std::map<Cell0, std::vector<KnownPositions::Position>> used;  ///< by every block with faces
  AdapterCounts counts{};
  std::vector<Mesh> meshes;  ///< what the last call gave, as blocks
  std::vector<MapBlock> blocks;
};

namespace {

constexpr double kUsualTolerance = 1.0 / 16;  // lattice steps

/// A block as the map has them, but for duplicated and nearly equal vertices.
Result<Mesh> in_terms_of_map(const MeshView& block, const MapDescription& description) {
  MeshView mesh = block;
  std::vector<std::uint32_t> soup;
  if (mesh.triangles.empty() && !mesh.positions.empty()) {
    if (mesh.positions.size() % 9 != 0)
      return invalid_mesh("a block without triangles has not three vertices for each");
    soup.resize(mesh.vertex_count());
    std::iota(soup.begin(), soup.end(), 0U);
    mesh.triangles = soup;
  }
  DELTAMESH_CHECK(check_mesh(mesh));
  DELTAMESH_TRY(const std::vector<Attribute> attributes, adapt_attributes(mesh, description));
  mesh.attributes.clear();
  for (const Attribute& a : attributes)
    mesh.attributes.push_back({a.kind, a.type, a.components, a.normalized, a.name, a.values, a.linear});
  return to_map(mesh, description);
}

bool has_two_corners_at_one_place(const Mesh& mesh, std::size_t face) {
  const std::uint32_t* corner = mesh.triangles.data() + 3 * face;
  const PositionBits a = bits_of(mesh, corner[0]);
  const PositionBits b = bits_of(mesh, corner[1]);
  const PositionBits c = bits_of(mesh, corner[2]);
  return a == b || b == c || c == a;
}

}  // namespace

/// `mesh` with known positions, which `used` gets, without the faces and the vertices that this makes
/// needless.
Mesh BlockAdapter::State::settled(Mesh mesh, std::vector<KnownPositions::Position>& to) {
  positions.begin_block();
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    float* const p = mesh.positions.data() + 3 * v;
    const KnownPositions::Position before = {p[0], p[1], p[2]};
    const KnownPositions::Position after = positions.settle(before, to);
    std::copy(after.begin(), after.end(), p);
    counts.vertices_moved += before == after ? 0 : 1;
  }
  RowGather gather{MeshView(mesh)};
  for (std::size_t f = 0; f < mesh.triangle_count(); ++f)
    if (!has_two_corners_at_one_place(mesh, f)) gather.add_face(f);
  const StoredBlock kept{.mesh = gather.take()};
  counts.faces_dropped += mesh.triangle_count() - kept.mesh.triangle_count();
  const StoredBlock* const blocks_of_part[] = {&kept};
  Mesh merged = std::move(assemble({}, blocks_of_part, {}).mesh);
  counts.vertices_merged += kept.mesh.vertex_count() - merged.vertex_count();
  return merged;
}

BlockAdapter::BlockAdapter(std::unique_ptr<State> state) noexcept : state_(std::move(state)) {}
BlockAdapter::BlockAdapter(BlockAdapter&&) noexcept = default;
BlockAdapter& BlockAdapter::operator=(BlockAdapter&&) noexcept = default;
BlockAdapter::~BlockAdapter() = default;

Result<BlockAdapter> BlockAdapter::make(MapDescription description, const AdapterOptions& options) noexcept {
  return guarded([&]() -> Result<BlockAdapter> {
    DELTAMESH_CHECK(validate(description));
    const double step = description.lattice.step();
    const double tolerance = options.tolerance.value_or(kUsualTolerance * step);
    if (!(tolerance >= 0 && tolerance <= step * description.cell_steps / 2))
      return invalid_argument("a tolerance of blocks out of 0 to half the edge of a cell");
    return BlockAdapter(std::make_unique<State>(std::move(description), tolerance));
  });
}

Result<std::span<const MapBlock>> BlockAdapter::update(std::span<const MapBlock> blocks) noexcept {
  return guarded([&]() -> Result<std::span<const MapBlock>> {
    State& state = *state_;
    std::map<Cell0, Mesh> given;
    for (const MapBlock& block : blocks) {
      const auto [place, is_new] = given.try_emplace(block.cell);
      if (!is_new) return at_block(invalid_argument("an update has a cell twice"), block);
      if (block.mesh.positions.empty() && block.mesh.triangles.empty()) continue;
      auto mesh = in_terms_of_map(block.mesh, state.description);
      if (!mesh) return at_block(mesh.error(), block);
      place->second = *std::move(mesh);
    }
    // First all go, so that none of them takes a position that only an older block had.
    for (const auto& [cell, mesh] : given) {
      const auto known = state.used.find(cell);
      if (known == state.used.end()) continue;
      state.positions.release(known->second);
      state.used.erase(known);
    }
    state.blocks.clear();
    state.meshes.clear();
    state.meshes.reserve(given.size());
    for (auto& [cell, mesh] : given) {
      Mesh& made = state.meshes.emplace_back();
      if (!mesh.triangles.empty()) made = state.settled(std::move(mesh), state.used[cell]);
      state.blocks.push_back({cell, made});
    }
    return std::span<const MapBlock>(state.blocks);
  });
}

Result<std::span<const MapBlock>> BlockAdapter::clear() noexcept {
  return guarded([&]() -> Result<std::span<const MapBlock>> {
    std::vector<MapBlock> all;
    for (const auto& [cell, positions] : state_->used) all.push_back({.cell = cell, .mesh = {}});
    return update(all);
  });
}

AdapterCounts BlockAdapter::counts() const noexcept { return state_->counts; }

}  // namespace deltamesh
