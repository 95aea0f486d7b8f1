// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// An asset in memory: its JSON, the bytes of its buffers, and what else a GLB held.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/gltf.h"
#include "glb.h"
#include "json.h"

namespace deltamesh::gltf {

inline constexpr const char* kExtensionName = "DELTAMESH_mesh_compression";

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

/// Reads and checks: the JSON has the shape of glTF 2 as far as its buffers, views, accessors and primitives
/// go, and every reference between those is in range. `asset` must outlive the document. Errors:
/// kInvalidFile, kFileOpen, kLimitExceeded, what `io.resolve` returns.
Result<Document> load_document(std::span<const std::byte> asset, const GltfIo& io);

/// Appends a buffer view with its own new buffer; returns its number.
std::size_t append_view(Document& document, std::vector<std::byte> bytes);

/// Writes the asset and completes `report` with the sizes before and after. Precondition: compact_document()
/// ran.
Result<GltfOutput> save_document(Document document, const GltfIo& io, const GltfReport& report);

}  // namespace deltamesh::gltf
