// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <utility>

#include "deltamesh/io.h"
#include "sequence.h"

namespace deltamesh {
namespace {

using nlohmann::ordered_json;

/// Appends blocks to one mesh.
class Collected {
 public:
  explicit Collected(bool is_welded) : is_welded_(is_welded) {}

  void add(const Mesh& block) {
    std::vector<std::uint32_t> numbers;
    for (std::size_t v = 0; v < block.vertex_count(); ++v) numbers.push_back(number_of(block, v));
    for (const std::uint32_t v : block.triangles) mesh_.triangles.push_back(numbers[v]);
  }
  const Mesh& mesh() const noexcept { return mesh_; }

 private:
  std::uint32_t number_of(const Mesh& block, std::size_t vertex) {
    std::array<float, 3> position{};
    std::copy_n(block.positions.begin() + static_cast<std::ptrdiff_t>(3 * vertex), 3, position.begin());
    const auto next = static_cast<std::uint32_t>(mesh_.vertex_count());
    if (is_welded_) {
      const auto [known, is_new] = known_.try_emplace(position, next);
      if (!is_new) return known->second;
    }
    mesh_.positions.insert(mesh_.positions.end(), position.begin(), position.end());
    for (std::size_t i = 0; i < block.attributes.size(); ++i) {
      const Attribute& from = block.attributes[i];
      if (mesh_.attributes.size() == i) {
        mesh_.attributes.push_back(from);
        mesh_.attributes.back().values.clear();
      }
      const std::size_t size = from.components * component_size(from.type);
      const auto value = from.values.begin() + static_cast<std::ptrdiff_t>(size * vertex);
      mesh_.attributes[i].values.insert(mesh_.attributes[i].values.end(), value,
                                        value + static_cast<std::ptrdiff_t>(size));
    }
    return next;
  }

  bool is_welded_;
  Mesh mesh_;
  std::map<std::array<float, 3>, std::uint32_t> known_;
};

std::string file_name(std::size_t step, const char* what) {
  std::array<char, 64> name{};
  std::snprintf(name.data(), name.size(), "step_%02zu_%s.ply", step, what);
  return name.data();
}

}  // namespace

Result<SequenceWriter> SequenceWriter::create(const std::string& folder, SequenceHeader header) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) return Error{.code = ErrorCode::kFileWrite, .message = "the folder cannot be made"};
  SequenceWriter writer;
  writer.folder_ = folder;
  writer.header_ = std::move(header);
  return writer;
}

Result<void> SequenceWriter::add(const SequenceStep& step, std::span<const SequenceBlock> blocks) {
  const std::size_t number = steps_.size();
  Collected changed(false);
  Collected whole(true);
  ordered_json ranges = ordered_json::array();
  for (const SequenceBlock& block : step.changed) {
    ranges.push_back({{"id", block.id},
                      {"first_vertex", changed.mesh().vertex_count()},
                      {"vertices", block.mesh.vertex_count()},
                      {"first_face", changed.mesh().triangle_count()},
                      {"faces", block.mesh.triangle_count()}});
    changed.add(block.mesh);
  }
  for (const SequenceBlock& block : blocks) whole.add(block.mesh);
  vertices_ = whole.mesh().vertex_count();
  triangles_ = whole.mesh().triangle_count();
  const ordered_json entry{{"step", number},
                           {"full", file_name(number, "full")},
                           {"changed", file_name(number, "changed")},
                           {"vertices", vertices_},
                           {"triangles", triangles_},
                           {"blocks_total", blocks.size()},
                           {"removed", step.removed},
                           {"blocks", ranges}};
  steps_.push_back(entry.dump());
  for (const auto& [mesh, what] : {std::pair(&changed.mesh(), "changed"), std::pair(&whole.mesh(), "full")})
    if (auto written = write_mesh_file(folder_ + '/' + file_name(number, what), *mesh); !written)
      return written;
  return write_json();
}

Result<void> SequenceWriter::write_json() const {
  ordered_json json{{"description", header_.description},
                    {"voxel", header_.voxel},
                    {"block_voxels", header_.block_voxels},
                    {"block_metres", header_.block_metres},
                    {"origin", header_.origin}};
  json["steps"] = ordered_json::array();
  for (const std::string& step : steps_) json["steps"].push_back(ordered_json::parse(step));
  const std::string text = json.dump(1) + '\n';
  return write_file(folder_ + "/sequence.json", std::as_bytes(std::span(text)));
}

}  // namespace deltamesh
