// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "deltamesh/io.h"
#include "sequence.h"

namespace deltamesh {
namespace {

Error invalid(const char* message) { return {.code = ErrorCode::kInvalidFile, .message = message}; }

}  // namespace

Result<SequenceReader> SequenceReader::open(const std::string& folder) {
  auto bytes = read_file(folder + "/sequence.json");
  if (!bytes) return bytes.error();
  SequenceReader reader;
  reader.folder_ = folder;
  try {
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    const auto json = nlohmann::json::parse(text);
    SequenceHeader& header = reader.header_;
    json.at("description").get_to(header.description);
    json.at("voxel").get_to(header.voxel);
    json.at("block_voxels").get_to(header.block_voxels);
    json.at("block_metres").get_to(header.block_metres);
    json.at("origin").get_to(header.origin);
    if (!(header.voxel > 0) || !(header.block_metres > 0)) return invalid("a length is not above 0");
    for (const auto& step : json.at("steps")) {
      Step& read = reader.steps_.emplace_back();
      step.at("changed").get_to(read.changed);
      step.at("full").get_to(read.whole);
      step.at("removed").get_to(read.removed);
      for (const auto& block : step.at("blocks"))
        read.blocks.push_back(
            {block.at("id").get<SequenceBlockId>(), block.at("first_vertex").get<std::size_t>(),
             block.at("vertices").get<std::size_t>(), block.at("first_face").get<std::size_t>(),
             block.at("faces").get<std::size_t>()});
    }
  } catch (const nlohmann::json::exception&) {
    return invalid("not a sequence of updates");
  }
  return reader;
}

Result<SequenceBlock> SequenceReader::cut_out(const Mesh& mesh, const BlockRange& range) {
  if (range.first_vertex > mesh.vertex_count() || range.vertices > mesh.vertex_count() - range.first_vertex ||
      range.first_face > mesh.triangle_count() || range.faces > mesh.triangle_count() - range.first_face)
    return invalid("a block beyond the end of its file");
  SequenceBlock block{range.id, {}};
  block.mesh.origin = mesh.origin;
  const auto positions = std::span(mesh.positions).subspan(3 * range.first_vertex, 3 * range.vertices);
  block.mesh.positions.assign(positions.begin(), positions.end());
  for (const std::uint32_t v : std::span(mesh.triangles).subspan(3 * range.first_face, 3 * range.faces)) {
    if (v < range.first_vertex || v - range.first_vertex >= range.vertices)
      return invalid("a face with a vertex of another block");
    block.mesh.triangles.push_back(static_cast<std::uint32_t>(v - range.first_vertex));
  }
  for (const Attribute& attribute : mesh.attributes) {
    Attribute copy = attribute;
    const std::size_t size = attribute.components * component_size(attribute.type);
    const auto values = std::span(attribute.values).subspan(size * range.first_vertex, size * range.vertices);
    copy.values.assign(values.begin(), values.end());
    block.mesh.attributes.push_back(std::move(copy));
  }
  return block;
}

Result<SequenceStep> SequenceReader::read(std::size_t step) const {
  const Step& from = steps_[step];
  SequenceStep result;
  result.removed = from.removed;
  if (from.blocks.empty()) return result;
  auto file = read_mesh_file(folder_ + '/' + from.changed);
  if (!file) return file.error();
  for (const BlockRange& range : from.blocks) {
    auto block = cut_out(file->mesh, range);
    if (!block) return block.error();
    result.changed.push_back(std::move(*block));
  }
  return result;
}

Result<Mesh> SequenceReader::read_whole(std::size_t step) const {
  auto file = read_mesh_file(folder_ + '/' + steps_[step].whole);
  if (!file) return file.error();
  return std::move(file->mesh);
}

}  // namespace deltamesh
