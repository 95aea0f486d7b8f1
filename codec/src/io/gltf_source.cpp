// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/gltf_source.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "base/byte_reader.h"
#include "base/try.h"
#include "deltamesh/io.h"
#include "io/gltf_uri.h"
#include "io/io_error.h"
#include "io/text_scanner.h"

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

bool is_plain(const json& value) {
  if (!value.is_array()) return value.is_primitive();
  return std::all_of(value.begin(), value.end(), [](const json& entry) { return entry.is_number(); });
}

/// Copies what is listed and has a harmless shape; remembers whether anything had not.
class Filter {
 public:
  bool ok() const noexcept { return ok_; }

  /// The named members of an object that are scalars or arrays of numbers.
  json members(const json& object, std::initializer_list<const char*> names) {
    json result = json::object();
    if (!expect(object.is_object())) return result;
    for (const char* const name : names) {
      const auto found = object.find(name);
      if (found == object.end()) continue;
      if (expect(is_plain(*found))) result[name] = *found;
    }
    return result;
  }

  /// Member `name`, passed through `change`; left out where absent.
  template <class F>
  void member(const json& object, const char* name, json& result, const F& change) {
    if (!object.is_object()) return;
    const auto found = object.find(name);
    if (found != object.end()) result[name] = change(*found);
  }

  /// The array `name`, every entry passed through `change`.
  template <class F>
  void array(const json& object, const char* name, json& result, const F& change) {
    member(object, name, result, [&](const json& entries) {
      json changed = json::array();
      if (!expect(entries.is_array())) return changed;
      for (const json& entry : entries) changed.push_back(change(entry));
      return changed;
    });
  }

  json accessor(const json& source) {
    json result =
        members(source, {"bufferView", "byteOffset", "normalized", "componentType", "count", "type"});
    member(source, "sparse", result, [this](const json& sparse) {
      json copy = members(sparse, {"count"});
      for (const char* const part : {"indices", "values"})
        member(sparse, part, copy, [this](const json& view) {
          return members(view, {"bufferView", "byteOffset", "componentType"});
        });
      return copy;
    });
    return result;
  }

  json mesh(const json& source) {
    json result = json::object();
    if (!expect(source.is_object())) return result;
    array(source, "primitives", result, [this](const json& primitive) {
      json copy = members(primitive, {"indices", "mode"});
      member(primitive, "attributes", copy, [this](const json& attributes) {
        const bool numbers = attributes.is_object() &&
                             std::all_of(attributes.begin(), attributes.end(),
                                         [](const json& accessor) { return accessor.is_number_integer(); });
        return expect(numbers) ? attributes : json::object();
      });
      return copy;
    });
    return result;
  }

 private:
  bool expect(bool condition) noexcept {
    ok_ = ok_ && condition;
    return condition;
  }

  bool ok_ = true;
};

Result<std::string> filtered(const json& root) {
  Filter filter;
  json result = filter.members(root, {"scene"});
  filter.member(root, "asset", result, [&](const json& asset) { return filter.members(asset, {"version"}); });
  filter.array(root, "bufferViews", result, [&](const json& view) {
    return filter.members(view, {"buffer", "byteOffset", "byteLength", "byteStride"});
  });
  filter.array(root, "accessors", result, [&](const json& accessor) { return filter.accessor(accessor); });
  filter.array(root, "meshes", result, [&](const json& mesh) { return filter.mesh(mesh); });
  filter.array(root, "nodes", result, [&](const json& node) {
    return filter.members(node, {"mesh", "children", "matrix", "rotation", "scale", "translation"});
  });
  filter.array(root, "scenes", result, [&](const json& scene) { return filter.members(scene, {"nodes"}); });
  if (!filter.ok()) return invalid_file("glTF: a property has a type that the schema does not allow");
  return result.dump();
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
  DELTAMESH_TRY(source.json, filtered(root));
  if (source.json.size() > std::numeric_limits<std::uint32_t>::max())
    return invalid_file("glTF: more than 4 GiB of JSON");
  DELTAMESH_CHECK(open_buffers(root, container, folder, source));
  return source;
}

}  // namespace deltamesh
