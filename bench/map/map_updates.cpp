// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "map/map_updates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include "deltamesh/io.h"
#include "drive.h"

namespace deltamesh::bench {
namespace {

/// Position and attributes of a vertex, as bytes.
std::string row_of(const Mesh& mesh, std::size_t vertex) {
  const auto* position = reinterpret_cast<const char*>(mesh.positions.data() + 3 * vertex);
  std::string row(position, 3 * sizeof(float));
  for (const Attribute& a : mesh.attributes) {
    const std::size_t size = a.components * component_size(a.type);
    row.append(reinterpret_cast<const char*>(a.values.data()) + size * vertex, size);
  }
  return row;
}

/// The faces of a mesh whatever their order, to tell whether a block has changed.
std::vector<std::string> content_of(const Mesh& mesh) {
  std::vector<std::string> faces;
  for (std::size_t f = 0; f < mesh.triangle_count(); ++f) {
    std::string face;
    for (std::size_t c = 0; c < 3; ++c) face += row_of(mesh, mesh.triangles[3 * f + c]);
    faces.push_back(std::move(face));
  }
  std::ranges::sort(faces);
  return faces;
}

class BlockCutter {
 public:
  explicit BlockCutter(const Mesh& mesh) : mesh_(mesh) {}

  std::map<SequenceBlockId, Mesh> run(double edge) {
    for (std::size_t f = 0; f < mesh_.triangle_count(); ++f) {
      SequenceBlockId id{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double sum = 0;
        for (std::size_t c = 0; c < 3; ++c)
          sum += double{mesh_.positions[3 * std::size_t{mesh_.triangles[3 * f + c]} + axis]};
        id[axis] = static_cast<std::int32_t>(std::floor(sum / 3 / edge));
      }
      for (std::size_t c = 0; c < 3; ++c) add_corner(id, mesh_.triangles[3 * f + c]);
    }
    return std::move(blocks_);
  }

 private:
  void add_corner(const SequenceBlockId& id, std::uint32_t vertex) {
    const auto [place, is_first] = blocks_.try_emplace(id);
    Mesh& block = place->second;
    if (is_first) {
      block.origin = mesh_.origin;
      block.attributes = mesh_.attributes;
      for (Attribute& a : block.attributes) a.values.clear();
    }
    const auto [number, is_new] =
        numbers_[id].try_emplace(vertex, static_cast<std::uint32_t>(block.vertex_count()));
    block.triangles.push_back(number->second);
    if (!is_new) return;
    const auto first = mesh_.positions.begin() + static_cast<std::ptrdiff_t>(3 * std::size_t{vertex});
    block.positions.insert(block.positions.end(), first, first + 3);
    for (std::size_t i = 0; i < block.attributes.size(); ++i) {
      const Attribute& from = mesh_.attributes[i];
      const std::size_t size = from.components * component_size(from.type);
      const auto value = from.values.begin() + static_cast<std::ptrdiff_t>(size * vertex);
      block.attributes[i].values.insert(block.attributes[i].values.end(), value,
                                        value + static_cast<std::ptrdiff_t>(size));
    }
  }

  const Mesh& mesh_;
  std::map<SequenceBlockId, Mesh> blocks_;
  std::map<SequenceBlockId, std::map<std::uint32_t, std::uint32_t>> numbers_;
};

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
                              int block_voxels) {
  MapUpdates updates{name, voxel, voxel * block_voxels, {}, {}, {}};
  std::map<SequenceBlockId, Mesh> before;
  for (int i = 0;; ++i) {
    const std::string number = (i < 10 ? "0" : "") + std::to_string(i);
    const std::string path = folder + "/step_" + number + ".ply";
    if (!std::filesystem::exists(path)) break;
    auto file = read_mesh_file(path);
    if (!file) return file.error();
    auto blocks = BlockCutter(file->mesh).run(updates.block_metres);
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

Result<MapUpdates> drive_updates(std::uint64_t vertices, std::uint32_t steps) {
  auto drive = Drive::make(vertices, 1);
  if (!drive) return drive.error();
  MapUpdates updates{"drive", drive->voxel(), kDriveBlockVoxels * drive->voxel(), drive->origin(), {}, {}};
  for (std::uint32_t i = 0; i < steps; ++i) {
    DriveUpdate update = drive->next();
    SequenceStep& step = updates.steps.emplace_back();
    for (DriveBlock& block : update.changed) step.changed.push_back({block.id, std::move(block.mesh)});
    step.removed = std::move(update.removed);
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

}  // namespace deltamesh::bench
