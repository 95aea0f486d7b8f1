// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// An asset in memory: its JSON, the bytes of its buffers, and what else a GLB held.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "deltamesh/result.h"
#include "io/gltf/glb.h"
#include "io/gltf/json.h"

namespace deltamesh::gltf {

/// Gives the bytes of an external buffer. Its argument is a relative path, percent-decoded, that names
/// nothing outside the asset's folder. An error that it returns is handed on.
using Resolver = std::function<Result<std::vector<std::byte>>(std::string_view path)>;

/// Bytes of buffers[i]. A buffer without URI that is no GLB chunk either has no bytes that we could know
/// (another extension fills it): it is opaque, and kept as it is.
struct Buffer {
  Buffer() = default;
  Buffer(Buffer&&) noexcept = default;  // `bytes` may point into `owned`: moved, never copied
  Buffer& operator=(Buffer&&) noexcept = default;

  std::vector<std::byte> owned;      ///< read from a URI, or new
  std::span<const std::byte> bytes;  ///< exactly byteLength of them; none where opaque
  bool opaque = false;
};

struct Document {
  Json json;
  std::vector<Buffer> buffers;       ///< one for each of json["buffers"]
  std::vector<GlbChunk> glb_chunks;  ///< chunks after BIN; their bytes belong to the asset that was loaded
  std::uint64_t input_bytes = 0;     ///< asset and external buffers
};

/// Reads GLB or JSON, told apart by content, and the buffers that it names; the JSON has passed
/// check_structure(). `asset` must outlive the document. `resolve`: empty: external buffers are refused.
/// Errors: kInvalidFile, kFileOpen, kLimitExceeded, what `resolve` returns.
Result<Document> load_document(std::span<const std::byte> asset, const Resolver& resolve);

/// Appends a buffer view with its own new buffer; returns its number.
std::size_t append_view(Document& document, std::vector<std::byte> bytes);

}  // namespace deltamesh::gltf
