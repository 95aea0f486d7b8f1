// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/gltf/document.h"

#include <map>
#include <string>
#include <utility>

#include "base/guard.h"
#include "base/try.h"
#include "base/with_found.h"
#include "io/gltf/structure.h"
#include "io/gltf/uri.h"
#include "io/text/scanner.h"

namespace deltamesh::gltf {
namespace {

Result<std::vector<std::byte>> resolve_uri(const std::string& uri, const Resolver& resolve,
                                           std::size_t number, std::uint64_t& input_bytes) {
  if (uri.starts_with("data:")) {
    auto bytes = decode_data_uri(uri);
    if (!bytes) return element_error("the buffer's data URI is not proper base64", number);
    return *std::move(bytes);
  }
  const auto path = relative_path_of(uri);
  if (!path)
    return element_error("the buffer's URI is unsafe: it is no path inside the asset's folder", number);
  if (!resolve)
    return Error{.code = ErrorCode::kFileOpen,
                 .message = "the asset has an external buffer, which cannot be reached from here",
                 .where_kind = WhereKind::kElement,
                 .where = number};
  auto bytes = call_back(resolve, *path);
  if (!bytes && bytes.error().code == ErrorCode::kFileOpen) {
    Error error = bytes.error();
    error.message = "a file that the asset names cannot be opened";
    return with_found(error, *path);
  }
  if (!bytes) return bytes.error();
  input_bytes += bytes->size();
  return bytes;
}

/// What a URI stands for: a file that two buffers name is read once, and belongs to the first.
using Resolved = std::map<std::string, std::span<const std::byte>>;

Result<Buffer> load_buffer(const Json& json, std::size_t number,
                           const std::optional<std::span<const std::byte>>& bin, const Resolver& resolve,
                           Resolved& resolved, std::uint64_t& input_bytes) {
  Buffer buffer;
  const Error bad_length = element_error("the buffer's byteLength is missing or malformed", number);
  if (!json.contains("byteLength")) return bad_length;
  DELTAMESH_TRY(const auto length, unsigned_member(json, "byteLength", 0, kNoLimit, bad_length));
  const Json* uri = find(json, "uri");
  if (uri) {
    if (!uri->is_string()) return element_error("the buffer's URI is not a string", number);
    const auto [known, is_new] = resolved.try_emplace(uri->get_ref<const std::string&>());
    if (is_new) {
      DELTAMESH_TRY(buffer.owned, resolve_uri(known->first, resolve, number, input_bytes));
      known->second = buffer.owned;
    }
    buffer.bytes = known->second;
  } else if (number == 0 && bin) {
    buffer.bytes = *bin;
  } else {
    buffer.opaque = true;
    return buffer;
  }
  if (length > buffer.bytes.size()) return element_error("the buffer is shorter than its byteLength", number);
  buffer.bytes = buffer.bytes.first(static_cast<std::size_t>(length));
  return buffer;
}

/// Whether a text begins as a JSON object does, perhaps with a byte order mark.
bool is_json_object(std::span<const std::byte> text) noexcept {
  const std::string_view characters = as_text(text);
  const auto first = characters.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  return first != std::string_view::npos && characters[first] == '{';
}

}  // namespace

Result<Document> load_document(std::span<const std::byte> asset, const Resolver& resolve) {
  Document document;
  document.input_bytes = asset.size();
  std::span<const std::byte> text = asset;
  std::optional<std::span<const std::byte>> bin;
  if (is_glb(asset)) {
    DELTAMESH_TRY(auto glb, parse_glb(asset));
    text = glb.json;
    bin = glb.bin;
    document.glb_chunks = std::move(glb.others);
  } else if (!is_json_object(asset)) {
    return Error{.code = ErrorCode::kInvalidFile,
                 .message = "neither a GLB nor the JSON text of a glTF asset"};
  }
  DELTAMESH_TRY(document.json, parse_json(text));
  DELTAMESH_CHECK(check_structure(document.json));
  if (const Json* buffers = find(document.json, "buffers")) {
    Resolved resolved;
    for (std::size_t i = 0; i < buffers->size(); ++i) {
      DELTAMESH_TRY(auto buffer, load_buffer((*buffers)[i], i, bin, resolve, resolved, document.input_bytes));
      document.buffers.push_back(std::move(buffer));
    }
  }
  return document;
}

std::size_t append_view(Document& document, std::vector<std::byte> bytes) {
  Json& views = document.json["bufferViews"];
  if (!views.is_array()) views = Json::array();
  Json& buffers = document.json["buffers"];
  if (!buffers.is_array()) buffers = Json::array();
  views.push_back(Json({{"buffer", document.buffers.size()}, {"byteLength", bytes.size()}}));
  buffers.push_back(Json({{"byteLength", bytes.size()}}));
  Buffer& buffer = document.buffers.emplace_back();
  buffer.owned = std::move(bytes);
  buffer.bytes = buffer.owned;
  return views.size() - 1;
}

}  // namespace deltamesh::gltf
