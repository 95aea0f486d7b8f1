// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "map/updates.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "deltamesh/find_grid.h"
#include "deltamesh/io.h"
#include "drive.h"
#include "report/text.h"
#include "rooms.h"
#include "scenes.h"
#include "support/vertex_picker.h"

namespace deltamesh::bench {
namespace {

/// The faces of a mesh whatever their order, to tell whether a block has changed.
std::vector<std::string> content_of(const Mesh& mesh) {
  std::vector<std::string> faces;
  for (std::size_t f = 0; f < mesh.triangle_count(); ++f) {
    std::string face;
    for (std::size_t c = 0; c < 3; ++c) face += vertex_bits(mesh, mesh.triangles[3 * f + c]);
    faces.push_back(std::move(face));
  }
  std::ranges::sort(faces);
  return faces;
}

/// A face lies in the block that has its middle; the block with identifier 0 begins at `origin`.
std::map<SequenceBlockId, Mesh> cut_in_blocks(const Mesh& mesh, double edge,
                                              const std::array<double, 3>& origin) {
  std::map<SequenceBlockId, VertexPicker> pickers;
  for (std::size_t f = 0; f < mesh.triangle_count(); ++f) {
    const std::span corners = std::span(mesh.triangles).subspan(3 * f, 3);
    SequenceBlockId id{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double sum = 0;
      for (const std::uint32_t v : corners) sum += double{mesh.positions[3 * std::size_t{v} + axis]};
      id[axis] = static_cast<std::int32_t>(std::floor((sum / 3 - origin[axis]) / edge));
    }
    VertexPicker& picker = pickers.try_emplace(id, mesh, false).first->second;
    for (const std::uint32_t v : corners) picker.add_corner(v);
  }
  std::map<SequenceBlockId, Mesh> blocks;
  for (auto& [id, picker] : pickers) blocks.emplace(id, picker.take());
  return blocks;
}

/// Relative to the map's origin; empty where there is none.
std::optional<VoxelGrid> grid_of(const MapUpdates& updates) {
  const Mesh& first = updates.wholes.front();
  auto grid = find_grid(first);
  for (std::size_t axis = 0; grid && axis < 3; ++axis)
    grid->origin[axis] += first.origin[axis] - updates.origin[axis];
  return grid;
}

}  // namespace

Result<MapUpdates> read_updates(const std::string& folder, const std::string& name) {
  auto reader = SequenceReader::open(folder);
  if (!reader) return reader.error();
  const SequenceHeader& header = reader->header();
  MapUpdates updates{name, header.voxel, header.block_metres, header.origin, {}, {}};
  for (std::size_t i = 0; i < reader->size(); ++i) {
    auto step = reader->read(i);
    if (!step) return step.error();
    auto whole = reader->read_whole(i);
    if (!whole) return whole.error();
    updates.steps.push_back(std::move(*step));
    updates.wholes.push_back(std::move(*whole));
  }
  return updates;
}

Result<MapUpdates> cut_wholes(const std::string& folder, const std::string& name, double voxel,
                              int block_voxels, const std::array<double, 3>& origin) {
  MapUpdates updates{name, voxel, voxel * block_voxels, origin, {}, {}};
  std::map<SequenceBlockId, Mesh> before;
  for (int i = 0;; ++i) {
    const std::string path = join({folder, i < 10 ? "/step_0" : "/step_", number(i), ".ply"});
    if (!std::filesystem::exists(path)) break;
    auto file = read_mesh_file(path);
    if (!file) return file.error();
    auto blocks = cut_in_blocks(file->mesh, updates.block_metres, origin);
    SequenceStep& step = updates.steps.emplace_back();
    for (const auto& [id, block] : blocks) {
      const auto known = before.find(id);
      if (known == before.end() || content_of(known->second) != content_of(block))
        step.changed.push_back({id, block});
    }
    for (const auto& [id, block] : before)
      if (!blocks.contains(id)) step.removed.push_back(id);
    updates.wholes.push_back(std::move(file->mesh));
    before = std::move(blocks);
  }
  if (updates.steps.empty()) return Error{.code = ErrorCode::kFileOpen, .message = "no step_00.ply"};
  return updates;
}

Result<MapUpdates> rooms_at_once(std::uint64_t vertices) {
  auto mesh = generate_scene(Scene::kRooms, vertices, 1);
  if (!mesh) return mesh.error();
  const double voxel = scenes::plan_rooms(vertices).voxel;
  MapUpdates updates{"rooms", voxel, kDriveBlockVoxels * voxel, mesh->origin, {}, {}};
  SequenceStep& step = updates.steps.emplace_back();
  for (auto& [id, block] : cut_in_blocks(*mesh, updates.block_metres, {}))
    step.changed.push_back({id, std::move(block)});
  updates.wholes.push_back(*std::move(mesh));
  return updates;
}

Result<MapUpdates> drive_updates(std::uint64_t vertices, std::uint32_t steps) {
  auto drive = Drive::make(vertices, 1);
  if (!drive) return drive.error();
  MapUpdates updates{"drive", drive->voxel(), kDriveBlockVoxels * drive->voxel(), drive->origin(), {}, {}};
  for (std::uint32_t i = 0; i < steps; ++i) {
    updates.steps.push_back(drive->next());
    Mesh whole;
    for (const auto& [id, mesh] : drive->blocks()) {
      const auto first = static_cast<std::uint32_t>(whole.vertex_count());
      whole.positions.insert(whole.positions.end(), mesh.positions.begin(), mesh.positions.end());
      for (const std::uint32_t v : mesh.triangles) whole.triangles.push_back(first + v);
    }
    updates.wholes.push_back(std::move(whole));
  }
  return updates;
}

MapDescription map_description(const MapUpdates& updates, double max_error) {
  MapDescription description{.id = 1, .epoch = 1, .frame = "map"};
  description.lattice = {.origin = updates.origin, .step_exponent = step_exponent_for(max_error)};
  description.cell_steps =
      static_cast<std::uint32_t>(std::lround(updates.block_metres / description.lattice.step()));
  description.grid = grid_of(updates);
  for (const Attribute& a : updates.steps.front().changed.front().mesh.attributes)
    description.attributes.push_back({a.kind, a.type, a.components, a.normalized, a.name, a.linear});
  return description;
}

}  // namespace deltamesh::bench
