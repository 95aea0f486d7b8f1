// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/gltf_source.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "base/byte_reader.h"
#include "base/try.h"
#include "deltamesh/io.h"
#include "io/gltf_filter.h"
#include "io/gltf_uri.h"
#include "io/io_error.h"
#include "io/text/scanner.h"

namespace deltamesh {
namespace {

using nlohmann::json;

constexpr std::uint32_t kGlbMagic = 0x46546c67;
constexpr std::uint32_t kJsonChunk = 0x4e4f534a;
constexpr std::uint32_t kBinaryChunk = 0x004e4942;

struct Container {
  std::string_view text;
  std::optional<std::span<const std::byte>> binary;
};

Result<Container> split_glb(std::span<const std::byte> bytes) {
  constexpr Error kShort = invalid_file("GLB: the file ends inside its header or a chunk");
  ByteReader header(bytes);
  if (header.remaining() < 12) return kShort;
  static_cast<void>(header.read<std::uint32_t>());
  const std::uint32_t version = *header.read<std::uint32_t>();
  const std::uint32_t length = *header.read<std::uint32_t>();
  if (version != 2) return invalid_byte("GLB: only version 2 is known", 4);
  if (length > bytes.size() || length < 12)
    return invalid_byte("GLB: the file is not as long as it states", 8);
  ByteReader in(bytes.subspan(12, length - 12));
  Container container;
  for (std::size_t i = 0; i < 2 && in.remaining() > 0; ++i) {
    if (in.remaining() < 8) return kShort;
    const std::uint32_t size = *in.read<std::uint32_t>();
    const std::uint32_t type = *in.read<std::uint32_t>();
    const auto chunk = in.read_bytes(size);
    if (!chunk) return kShort;
    if (i == 0 && type != kJsonChunk) return invalid_byte("GLB: the first chunk is not JSON", 12);
    if (i == 0) container.text = as_text(*chunk);
    if (i == 1 && type == kBinaryChunk) container.binary = *chunk;
  }
  return container;
}

Result<Container> split(std::span<const std::byte> bytes) {
  ByteReader in(bytes);
  const auto magic = in.read<std::uint32_t>();
  if (magic && *magic == kGlbMagic) return split_glb(bytes);
  return Container{.text = as_text(bytes), .binary = std::nullopt};
}

/// Required extensions that leave the accessors' meaning alone.
bool is_harmless(std::string_view extension) noexcept {
  constexpr std::array<std::string_view, 8> kPrefixes{
      "KHR_materials_", "KHR_texture_",          "KHR_lights_", "EXT_lights_",
      "EXT_texture_",   "KHR_mesh_quantization", "KHR_xmp",     "KHR_animation_"};
  return std::any_of(kPrefixes.begin(), kPrefixes.end(),
                     [extension](std::string_view prefix) { return extension.starts_with(prefix); });
}

Result<void> check_extensions(const json& root) {
  const auto required = root.find("extensionsRequired");
  if (required == root.end()) return {};
  if (!required->is_array()) return invalid_file("glTF: extensionsRequired is not an array");
  for (const json& entry : *required) {
    const auto* const name = entry.get_ptr<const std::string*>();
    if (name == nullptr) return invalid_file("glTF: extensionsRequired holds something else than names");
    if (*name == "DELTAMESH_mesh_compression")
      return invalid_file("glTF: the file is packed by deltamesh; unpack it first");
    if (*name == "KHR_draco_mesh_compression")
      return invalid_file("glTF: meshes compressed by Draco are not supported");
    if (*name == "EXT_meshopt_compression" || *name == "KHR_meshopt_compression")
      return invalid_file("glTF: buffers compressed by meshoptimizer are not supported");
    if (!is_harmless(*name))
      return invalid_file("glTF: the file requires an extension that is not supported");
  }
  return {};
}

Result<std::vector<std::byte>> load(const std::string& uri, std::string_view folder) {
  if (uri.starts_with("data:")) {
    auto decoded = decode_data_uri(uri);
    if (!decoded) return invalid_file("glTF: a buffer's data URI is not valid base64");
    return *std::move(decoded);
  }
  const auto path = relative_path_of(uri);
  if (!path) return invalid_file("glTF: a buffer's URI leads out of the file's folder");
  if (folder.empty()) return invalid_file("glTF: a buffer is in another file, and no folder is given");
  return read_file(std::string(folder) + '/' + *path);
}

Result<void> open_buffers(const json& root, const Container& container, std::string_view folder,
                          GltfSource& source) {
  const auto buffers = root.find("buffers");
  if (buffers == root.end()) return {};
  if (!buffers->is_array()) return invalid_file("glTF: buffers is not an array");
  source.owned.reserve(buffers->size());
  std::map<std::string, std::span<const std::byte>> loaded;  // one file named twice is read once
  for (const json& buffer : *buffers) {
    const auto length = buffer.is_object() ? buffer.find("byteLength") : buffer.end();
    if (length == buffer.end() || !length->is_number_unsigned())
      return invalid_file("glTF: a buffer without a length");
    const auto uri = buffer.find("uri");
    std::span<const std::byte> bytes;
    if (uri == buffer.end()) {
      if (!container.binary || !source.buffers.empty())
        return invalid_file("glTF: a buffer that is neither in the file nor elsewhere");
      bytes = *container.binary;
    } else {
      const auto* const text = uri->get_ptr<const std::string*>();
      if (text == nullptr) return invalid_file("glTF: a buffer's URI is not a text");
      const auto known = loaded.find(*text);
      if (known == loaded.end()) {
        DELTAMESH_TRY(std::vector<std::byte> content, load(*text, folder));
        source.total_bytes += content.size();
        loaded[*text] = source.owned.emplace_back(std::move(content));
      }
      bytes = loaded[*text];
    }
    if (length->get<std::uint64_t>() > bytes.size())
      return invalid_file("glTF: a buffer has fewer bytes than it states");
    source.buffers.push_back(bytes.first(length->get<std::uint64_t>()));
  }
  return {};
}

}  // namespace

Result<GltfSource> open_gltf(std::span<const std::byte> bytes, std::string_view folder) {
  DELTAMESH_TRY(const Container container, split(bytes));
  // The parser keeps its own stack on the heap: nesting cannot exhaust ours.
  const json root = json::parse(container.text, nullptr, /*allow_exceptions=*/false);
  if (!root.is_object()) return invalid_file("glTF: the file is not a JSON object");
  DELTAMESH_CHECK(check_extensions(root));
  GltfSource source;
  source.total_bytes = bytes.size();
  DELTAMESH_TRY(source.json, filtered_gltf(root));
  if (source.json.size() > std::numeric_limits<std::uint32_t>::max())
    return invalid_file("glTF: more than 4 GiB of JSON");
  DELTAMESH_CHECK(open_buffers(root, container, folder, source));
  return source;
}

}  // namespace deltamesh
